//! Rays of numbers that are none, infinite, zero, tiny or huge: they end soon, and find
//! nothing or something at a finite t.

mod answers;
#[path = "../common/mod.rs"]
mod common;
mod trees;
mod visits;

use common::random::Numbers;
use glam::DVec3;
use rayproof::kernel::aabb::FARTHEST;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::vector::vec3;
use trees::{CENTER, REACH};

/// What stands in place of a ray's numbers.
const ODD: [f32; 12] = [
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    0.0,
    -0.0,
    1e-39,
    -1e-39,
    1e-30,
    1e-20,
    1e25,
    -1e25,
    f32::MAX,
];

/// Whether the long tests are asked for.
fn thorough() -> bool {
    std::env::var_os("RAYPROOF_THOROUGH").is_some()
}

fn ray_of(numbers: [f32; 6]) -> Ray<f32> {
    let [ox, oy, oz, dx, dy, dz] = numbers;
    Ray {
        origin: vec3(ox, oy, oz),
        direction: vec3(dx, dy, dz),
    }
}

fn numbers_of(ray: Ray<f32>) -> [f32; 6] {
    let ([ox, oy, oz], [dx, dy, dz]): ([f32; 3], [f32; 3]) =
        (ray.origin.into(), ray.direction.into());
    [ox, oy, oz, dx, dy, dz]
}

/// A ray from inside the scene or from around it through a point in it.
fn ordinary_ray(n: &mut Numbers) -> Ray<f32> {
    let reach = if n.next().is_multiple_of(2) { 1.0 } else { 4.0 };
    let from = CENTER + n.vector(REACH * reach);
    let to = CENTER + n.vector(REACH / 2.0);
    let [origin, direction] = [from, to - from].map(|v: DVec3| {
        let [x, y, z] = v.as_vec3().to_array();
        vec3(x, y, z)
    });
    Ray { origin, direction }
}

/// The ray with one odd number in some of its places, a bit each.
fn spoilt(ray: Ray<f32>, places: u32, odd: f32) -> Ray<f32> {
    let mut numbers = numbers_of(ray);
    for (place, number) in numbers.iter_mut().enumerate() {
        if places >> place & 1 == 1 {
            *number = odd;
        }
    }
    ray_of(numbers)
}

/// Whether it is no ray: not of finite numbers, or of no direction. It misses everything.
fn is_no_ray(ray: Ray<f32>) -> bool {
    let numbers = numbers_of(ray);
    numbers.iter().any(|number| !number.is_finite()) || numbers[3..].iter().all(|d| *d == 0.0)
}

/// Whether it meets no box: no ray, or from farther away than any scene reaches, or of a
/// length that is not finite.
fn meets_no_box(ray: Ray<f32>) -> bool {
    let [ox, oy, oz, dx, dy, dz] = numbers_of(ray).map(f32::abs);
    is_no_ray(ray) || ox + oy + oz > FARTHEST || dx + dy + dz > f32::MAX
}

/// Every odd number in every combination of places, and mixtures of them.
fn odd_rays(seed: u64, mixtures: usize) -> Vec<Ray<f32>> {
    let mut n = Numbers(seed);
    let mut rays = Vec::new();
    for odd in ODD {
        rays.extend((1..64).map(|places| spoilt(ordinary_ray(&mut n), places, odd)));
    }
    for _ in 0..mixtures {
        let ordinary = numbers_of(ordinary_ray(&mut n));
        rays.push(ray_of(ordinary.map(|number| {
            let pick = n.next() as usize % (2 * ODD.len());
            ODD.get(pick).copied().unwrap_or(number)
        })));
    }
    rays
}

//! Rays that leave a surface do not meet it again, whatever its size and distance.

use glam::DVec3;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::hit::{Hit, no_hit};
use rayproof::kernel::offset::leave_surface;
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::real::Real;
use rayproof::kernel::sphere::{sphere_normal, sphere_point};
use rayproof::kernel::trace::find_hit;
use rayproof::kernel::triangle::{triangle_normal, triangle_point, triangle_weights};
use rayproof::kernel::triangles::triangle_of;
use rayproof::kernel::two_float::TwoFloat;
use rayproof::kernel::vector::{Vec3, dot_product, face_viewer, taxicab_length};
use rayproof::scene::{Geometry, Shape, Transform};
use rayproof::tier::Textbook;

use super::common::random::Numbers;
use super::common::white_scene;

/// Rays of each kind, size and distance.
const RAYS: usize = 2000;

/// Sizes, and distances in parts of them: 20 together.
const SIZES: [f64; 5] = [1e-6, 1e-3, 1.0, 1e3, 1e6];
const DISTANCES: [f64; 4] = [2.0, 10.0, 100.0, 1000.0];

/// A sphere or a triangle of a size at a distance from the camera.
fn scene_of<R: Real>(triangle: bool, size: f64, distance: f64) -> (Flat<R>, DVec3) {
    let center = DVec3::new(0.36, 0.48, -0.8) * (size * distance);
    let corner = |x: f64, y: f64| center + DVec3::new(x, y, 0.3 * x - 0.2 * y) * size;
    let geometry = if triangle {
        Geometry::Triangle {
            vertices: [corner(-1.0, -0.8), corner(1.1, -0.6), corner(0.1, 1.0)],
        }
    } else {
        Geometry::Sphere {
            center,
            radius: size,
        }
    };
    let mut scene = white_scene(vec![Shape {
        geometry,
        transform: Transform::default(),
        material: 0,
    }]);
    scene.camera.eye = DVec3::ZERO;
    scene.camera.target = -DVec3::Z;
    (flatten::<R>(&scene), center)
}

/// The point that is hit, the unit normal towards the camera, and the shape's reach.
fn surface_of<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> (Vec3<R>, Vec3<R>, R) {
    if let Some(sphere) = flat.spheres.first() {
        let normal = sphere_normal(ray, sphere, hit.t);
        let point = sphere_point(ray, sphere, normal, hit.t);
        let reach = taxicab_length(Vec3::from(sphere.center)) + sphere.radius;
        return (point, face_viewer(normal, ray.direction), reach);
    }
    let triangle = triangle_of(flat, flat.triangles[0]);
    let point = triangle_point(&triangle, triangle_weights(ray, &triangle));
    let lengths = [triangle.a, triangle.b, triangle.c].map(|c| taxicab_length(Vec3::from(c)));
    let longest = lengths
        .into_iter()
        .fold(R::ZERO, |a, b| if a > b { a } else { b });
    let normal = face_viewer(triangle_normal(&triangle), ray.direction);
    (point, normal, longest)
}

fn real_vector<R: Real>(v: DVec3) -> Vec3<R> {
    Vec3::from(v.to_array().map(R::from_f64))
}

/// Of rays that hit the shape and go on from there, outward, those that meet it again.
fn met_again<R: Real>(triangle: bool, size: f64, distance: f64) -> usize {
    let (flat, center) = scene_of::<R>(triangle, size, distance);
    let mut n = Numbers(7);
    let (mut left, mut again) = (0, 0);
    // The textbook sees nothing of a small triangle.
    for _ in 0..20 * RAYS {
        if left == RAYS {
            break;
        }
        let aim = center + n.vector(0.7 * size);
        let ray = Ray {
            origin: Vec3::default(),
            direction: real_vector(aim / (size * distance)),
        };
        let mut hit = no_hit();
        find_hit(&flat, probe_of(ray), &mut hit);
        if hit.id != 0 {
            continue;
        }
        let (point, normal, reach) = surface_of(&flat, ray, hit);
        // Every third ray grazes the surface.
        let mut direction = real_vector::<R>(n.vector(1.0));
        if left % 3 == 0 {
            direction = direction - normal * (dot_product(direction, normal) * R::from_f64(0.999));
        }
        if dot_product(direction, normal) <= R::ZERO {
            direction = -direction;
        }
        left += 1;
        let origin = leave_surface(point, normal, direction, reach);
        let mut second = no_hit();
        find_hit(&flat, probe_of(Ray { origin, direction }), &mut second);
        again += usize::from(second.id == 0);
    }
    again
}

fn all_configurations<R: Real>() -> Vec<(bool, f64, f64, usize)> {
    let mut found = Vec::new();
    for triangle in [false, true] {
        for size in SIZES {
            for distance in DISTANCES {
                found.push((
                    triangle,
                    size,
                    distance,
                    met_again::<R>(triangle, size, distance),
                ));
            }
        }
    }
    found
}

#[test]
fn no_stable_tier_meets_the_surface_that_it_leaves() {
    for (name, found) in [
        ("robust", all_configurations::<f32>()),
        ("extended", all_configurations::<TwoFloat>()),
        ("double", all_configurations::<f64>()),
    ] {
        for (triangle, size, distance, again) in found {
            let shape = if triangle { "triangle" } else { "sphere" };
            assert_eq!(again, 0, "{name}, {shape} of {size}, {distance} sizes away");
        }
    }
}

/// The control: a fixed offset is too small for large shapes.
#[test]
fn a_fixed_offset_is_not_enough() {
    let found = all_configurations::<Textbook>();
    let worst = found.iter().map(|(.., again)| *again).max();
    assert!(worst > Some(RAYS / 5), "{found:?}");
}

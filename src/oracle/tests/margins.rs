//! Margins tell which rays turn when they are a little off, and which do not.

use super::pictures::{crowd, crowd_rays, rays, scene, with_tree};
use super::{Draw, Numbers, Shapes, ray};
use crate::bounds::{Bounds, bound};
use crate::flat::Flat;
use crate::flatten::flatten;
use crate::kernel::camera::{Ray, camera_ray};
use crate::kernel::hit::no_hit;
use crate::kernel::probe::probe_of;
use crate::kernel::trace::find_hit;
use crate::kernel::vector::{Vec3, vector_length};
use crate::layout::NO_HIT;
use crate::oracle::Oracle;
use crate::scene::Scene;

/// Within what margin a kernel in f32 may err: eight of its roundings.
const F32_MARGIN: f64 = 8.0 / 16_777_216.0;

#[track_caller]
fn assert_margin(shapes: &Shapes, direction: [f64; 3], expected: f64) {
    let margin = shapes.oracle().closest(ray([0.0; 3], direction)).margin;
    assert!(
        (margin / expected - 1.0).abs() < 1e-6,
        "{margin} {expected}"
    );
}

/// Margins that can be told by hand, in parts of t |d| + |c| + r.
#[test]
fn margins_of_known_cases() {
    let ahead = [0.0, 0.0, 1.0];
    let small = 1.0 / 1024.0;
    // Outlines and rims: just within and just without.
    let far = (25.0 + 1e6_f64).sqrt();
    for off in [small, -small] {
        let radius = 5.0 + off;
        let disk = Shapes::none().disk([3.0, 4.0, 1e3], [0.0, 0.0, 2.0], radius);
        assert_margin(&disk, ahead, small / (1e3 + far + radius));
        let sphere = Shapes::none().sphere([3.0, 4.0, 1e3], radius);
        let front = 1e3 - (radius * radius - 25.0).max(0.0).sqrt();
        assert_margin(&sphere, ahead, small / (front + far + radius));
        // The nearest edge is x = off.
        let corners = [[-off, -8.0, 6.0], [-off, 8.0, 6.0], [9.0, 0.0, 6.0]];
        let size = 117_f64.sqrt();
        assert_margin(
            &Shapes::none().triangle(corners),
            ahead,
            small / (6.0 + size),
        );
        // A plane that is nearly met, or nearly missed.
        let plane = Shapes::none().plane([0.0, -9.0, 0.0], [0.0, 1.0, 0.0]);
        assert_margin(
            &plane,
            [1.0, off, 0.0],
            small / (1.0 + small * small).sqrt(),
        );
    }
    // Passed by edge-on, its plane 34 behind.
    let [near, far] = [-small, -1.1 * small];
    let corners = [[-1.0, near, 6.0], [1.0, near, 6.0], [0.0, far, 10.0]];
    let size = (100.0 + far * far).sqrt();
    assert_margin(
        &Shapes::none().triangle(corners),
        ahead,
        small / (6.0 + size),
    );
    // What is behind comes near; what is behind far enough does not matter, nor what is
    // nearly hit there.
    let wall = |z| {
        Shapes::none()
            .plane([0.0, 0.0, 4.0], [0.0, 0.0, 1.0])
            .plane([0.0, 0.0, z], [0.0, 0.0, 1.0])
            .sphere([5.0, 0.0, 20.0], 5.0)
    };
    assert_margin(&wall(4.0 + small), ahead, small / (8.0 + 2.0 * small));
    // 16 of 20 + root 425 + 5.
    let behind = 16.0 / (25.0 + 425_f64.sqrt());
    assert_margin(&wall(400.0), ahead, behind.min(396.0 / 800.0));
}

/// Of rays that are turned aside by `shift` of their length: those that have a smaller
/// margin, those of them whose hit turns, and the largest margin of all whose hit turns.
fn turned(flat: &Flat<f64>, rays: impl Iterator<Item = Ray<f64>>, shift: f64) -> (u32, u32, f64) {
    let oracle = Oracle::new(flat);
    let mut n = Numbers(8);
    let (mut near, mut near_turned, mut largest) = (0, 0, 0_f64);
    for ray in rays {
        let aside = Vec3::from(n.point(1.0)) * (shift * vector_length(ray.direction));
        let direction = ray.direction + aside;
        let truth = oracle.closest(ray);
        let is_turned = oracle.closest(Ray { direction, ..ray }).id != truth.id;
        if truth.margin < shift / 8.0 {
            near += 1;
            near_turned += u32::from(is_turned);
        }
        if is_turned {
            largest = largest.max(truth.margin);
        }
    }
    (near, near_turned, largest)
}

#[test]
fn only_rays_with_a_small_margin_turn() {
    for shift in [1e-4, 1e-6, 1e-9] {
        let knot = with_tree(&scene("knot", 60));
        let shapes = with_tree(&scene("shapes", 100));
        let crowd = crowd();
        let of_crowd = crowd_rays(&crowd).into_iter();
        for (near, near_turned, largest) in [
            turned(&knot, rays(&knot), shift),
            turned(&shapes, rays(&shapes), shift),
            turned(&crowd, of_crowd, shift),
        ] {
            assert!(
                largest < 2.0 * shift,
                "{shift} {near} {near_turned} {largest}"
            );
            // And a small one is no false alarm.
            assert!(
                near < 50 || near_turned * 5 > near,
                "{shift} {near} {near_turned}"
            );
        }
    }
}

/// Rays of f32 at the corners of a mesh, at points of its edges and of its middle.
fn rays_at(flat: &Flat<f32>) -> Vec<Ray<f32>> {
    let mut rays = Vec::new();
    let mut n = Numbers(9);
    for corners in flat.triangles.iter().step_by(7) {
        let [a, b, c] = corners
            .vertices
            .map(|vertex| Vec3::from(flat.vertices[vertex as usize]));
        let weight = n.between(0.0, 1.0) as f32;
        for at in [a, a * weight + b * (1.0 - weight), (a + b + c) * 0.25] {
            rays.push(Ray {
                origin: Vec3::default(),
                direction: at,
            });
        }
    }
    rays
}

/// The kernel in f32 against what its own numbers give exactly: it errs, on small margins
/// only. The control: it does err, and most margins are larger.
#[test]
fn the_kernel_in_f32_errs_on_small_margins_only() {
    let knot = Scene::load("assets/scenes/knot.toml").unwrap();
    let mut narrow: Flat<f32> = flatten(&knot);
    bound(&mut narrow, Bounds::Tree);
    let wide = narrow.converted::<f64>();
    let oracle = Oracle::new(&wide);
    let (mut errs, mut large) = (0, 0);
    for ray in rays_at(&narrow) {
        let mut hit = no_hit();
        find_hit(&narrow, probe_of(ray), &mut hit);
        let truth = oracle.closest(ray.converted::<f64>());
        large += u32::from(truth.margin > F32_MARGIN);
        if hit.id != truth.id {
            errs += 1;
            assert!(truth.margin < F32_MARGIN, "{ray:?} {hit:?} {truth:?}");
        }
    }
    assert!(errs > 100, "{errs}");
    assert!(large > 1000, "{large}");
}

/// A pixel's ray in f64 is another than in f32, and its t is seen to be off.
#[test]
fn what_f32_was_given_is_not_what_f64_was() {
    let knot = Scene::load("assets/scenes/knot.toml")
        .unwrap()
        .with_size(50, 50);
    let mut narrow: Flat<f32> = flatten(&knot);
    bound(&mut narrow, Bounds::Tree);
    let (wide, other) = (narrow.converted::<f64>(), with_tree(&flatten(&knot)));
    let (mut same, mut all) = (0, 0);
    for y in 0..50 {
        for x in 0..50 {
            let ray = camera_ray(&narrow.camera, narrow.size, x, y).converted::<f64>();
            let of_f32 = Oracle::new(&wide).closest(ray);
            let of_f64 = Oracle::new(&other).closest(camera_ray(&other.camera, other.size, x, y));
            if of_f32.id != NO_HIT && of_f64.id != NO_HIT {
                all += 1;
                same += u32::from(of_f32.t == of_f64.t);
                assert!((of_f32.t / of_f64.t - 1.0).abs() < 1e-3);
            }
        }
    }
    assert!(all > 500 && same * 10 < all, "{same} of {all}");
}

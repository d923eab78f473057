//! Whole pictures: the tree leaves nothing out, and the kernel in f64 sees the same.

use std::time::Instant;

use super::{Numbers, Shapes, ray};
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

fn scene(name: &str, size: u32) -> Flat<f64> {
    let file = format!("assets/scenes/{name}.toml");
    flatten(&Scene::load(file).unwrap().with_size(size, size))
}

fn with_tree(flat: &Flat<f64>) -> Flat<f64> {
    let mut with_tree = flat.clone();
    bound(&mut with_tree, Bounds::Tree);
    with_tree
}

fn rays(flat: &Flat<f64>) -> impl Iterator<Item = Ray<f64>> {
    let [width, height] = flat.size;
    (0..height)
        .flat_map(move |y| (0..width).map(move |x| camera_ray(&flat.camera, flat.size, x, y)))
}

/// Spheres, disks and triangles all about.
fn crowd() -> Flat<f64> {
    let mut n = Numbers(6);
    let mut shapes = Shapes::none();
    for _ in 0..40 {
        shapes = shapes.sphere(n.point(20.0), n.between(0.01, 2.0));
    }
    shapes = shapes.plane([0.0, -15.0, 0.0], [0.0, 1.0, 0.1]);
    for _ in 0..40 {
        shapes = shapes.disk(n.point(20.0), n.point(1.0), n.between(0.01, 3.0));
    }
    for _ in 0..120 {
        let corner = n.point(20.0);
        let corners = [0; 3].map(|_| {
            let offset = n.point(3.0);
            std::array::from_fn(|axis| corner[axis] + offset[axis])
        });
        shapes = shapes.triangle(corners);
    }
    shapes.0
}

/// Rays from the camera, and from elsewhere at points of the shapes.
fn crowd_rays(flat: &Flat<f64>) -> Vec<Ray<f64>> {
    let mut n = Numbers(7);
    let mut rays = Vec::new();
    for _ in 0..10 {
        for sphere in &flat.spheres {
            let to = sphere.center.map(|x| x + n.between(-2.0, 2.0));
            rays.push(ray([0.0; 3], to));
            let from = n.point(3000.0);
            let toward = std::array::from_fn(|axis| to[axis] - from[axis]);
            rays.push(ray(from, toward));
        }
        for corners in &flat.triangles {
            // At a corner exactly, from where all coordinates are whole.
            let to = flat.vertices[corners.vertices[0] as usize];
            rays.push(ray([0.0; 3], to));
            let from = [n.whole(4), n.whole(4), n.whole(4)];
            rays.push(ray(from, std::array::from_fn(|axis| to[axis] - from[axis])));
        }
    }
    rays
}

#[track_caller]
fn assert_tree_changes_nothing(flat: &Flat<f64>, rays: impl Iterator<Item = Ray<f64>>) {
    let tree = with_tree(flat);
    let (plain, quick) = (Oracle::new(flat), Oracle::new(&tree));
    let mut near = 0;
    for ray in rays {
        let (expected, truth) = (plain.closest(ray), quick.closest(ray));
        let [seen, wanted] = [truth, expected].map(|truth| (truth.id, truth.t, truth.t_rest));
        assert_eq!(seen, wanted, "{ray:?}");
        let small = 2_f64.powi(-21);
        assert!(truth.margin >= expected.margin);
        assert!(
            truth.margin == expected.margin || expected.margin > small,
            "{ray:?}"
        );
        near += u32::from(expected.margin < small);
        if expected.id != NO_HIT {
            let first = plain.candidates(ray)[0];
            let first = (first.id, first.t, first.t_rest);
            assert_eq!(first, wanted);
        }
    }
    println!("{near} rays with a small margin");
}

#[test]
fn a_tree_changes_nothing() {
    let crowd = crowd();
    assert_tree_changes_nothing(&crowd, crowd_rays(&crowd).into_iter());
    for name in ["seed-spheres", "shapes"] {
        let flat = scene(name, 60);
        assert_tree_changes_nothing(&flat, rays(&flat));
    }
}

/// Within what margin the kernel in f64 may see another primitive: its roundings, with room.
const F64_MARGIN: f64 = 1e-14;

/// Rays on which the kernel sees another primitive, and the largest margin among them.
fn differing(flat: &Flat<f64>, rays: impl Iterator<Item = Ray<f64>>) -> (u32, f64) {
    let oracle = Oracle::new(flat);
    let (mut count, mut largest) = (0, 0_f64);
    for ray in rays {
        let mut hit = no_hit();
        find_hit(flat, probe_of(ray), &mut hit);
        let truth = oracle.closest(ray);
        if hit.id != truth.id {
            count += 1;
            largest = largest.max(truth.margin);
        } else if hit.id != NO_HIT {
            let off = ((hit.t - truth.t) - truth.t_rest) / truth.t;
            assert!(off.abs() < 1e-6, "{off} {ray:?} {truth:?}");
        }
    }
    (count, largest)
}

#[test]
fn the_kernel_in_f64_sees_the_same() {
    for (name, size) in [("seed-spheres", 100), ("shapes", 100), ("knot", 60)] {
        let flat = with_tree(&scene(name, size));
        let (count, largest) = differing(&flat, rays(&flat));
        assert!(
            largest < F64_MARGIN,
            "{name}: {count} rays, margin {largest}"
        );
    }
    let crowd = with_tree(&crowd());
    let (count, largest) = differing(&crowd, crowd_rays(&crowd).into_iter());
    assert!(largest < F64_MARGIN, "{count} rays, margin {largest}");
}

/// The control: rays off by 1e-7 are seen to differ, and the margin tells how far.
#[test]
fn rays_that_are_off_are_caught() {
    let flat = with_tree(&scene("knot", 60));
    let oracle = Oracle::new(&flat);
    let mut n = Numbers(8);
    let (mut differ, mut largest) = (0, 0_f64);
    let shift = 1e-5;
    for ray in rays(&flat) {
        let off = Vec3::from(n.point(shift)) * vector_length(ray.direction);
        let direction = ray.direction + off;
        let truth = oracle.closest(ray);
        if oracle.closest(Ray { direction, ..ray }).id != truth.id {
            differ += 1;
            largest = largest.max(truth.margin);
        }
    }
    assert!(differ > 0);
    assert!(
        largest > F64_MARGIN && largest < 2.0 * shift,
        "{differ} {largest}"
    );
}

#[test]
#[ignore = "measures"]
fn speed() {
    for name in ["seed-spheres", "knot", "shapes"] {
        let flat = with_tree(&scene(name, 300));
        let oracle = Oracle::new(&flat);
        let started = Instant::now();
        let mut hits = 0;
        for ray in rays(&flat) {
            hits += u32::from(oracle.closest(ray).id != NO_HIT);
        }
        let each = started.elapsed().as_secs_f64() * 1e6 / f64::from(flat.size[0] * flat.size[1]);
        println!("{name}: {each:.2} microseconds a ray, {hits} hits");
    }
}

//! Whole pictures: the tree leaves nothing out, and the kernel in f64 sees the same.

use rayon::prelude::*;

use super::{Draw, Numbers, Shapes, ray};
use crate::bounds::{Bounds, bound};
use crate::flat::Flat;
use crate::flatten::flatten;
use crate::kernel::camera::{Ray, camera_ray};
use crate::kernel::hit::no_hit;
use crate::kernel::probe::probe_of;
use crate::kernel::trace::find_hit;
use crate::layout::NO_HIT;
use crate::oracle::{Oracle, Truth};
use crate::scene::Scene;

pub(super) fn scene(name: &str, size: u32) -> Flat<f64> {
    let file = format!("assets/scenes/{name}.toml");
    flatten(&Scene::load(file).unwrap().with_size(size, size))
}

pub(super) fn with_tree(flat: &Flat<f64>) -> Flat<f64> {
    let mut with_tree = flat.clone();
    bound(&mut with_tree, Bounds::Tree);
    with_tree
}

pub(super) fn rays(flat: &Flat<f64>) -> impl Iterator<Item = Ray<f64>> {
    let [width, height] = flat.size;
    (0..height)
        .flat_map(move |y| (0..width).map(move |x| camera_ray(&flat.camera, flat.size, x, y)))
}

/// Spheres, disks and triangles all about.
pub(super) fn crowd() -> Flat<f64> {
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
pub(super) fn crowd_rays(flat: &Flat<f64>) -> Vec<Ray<f64>> {
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

/// How many rays a tree changes the answer to.
fn changed_by_tree(flat: &Flat<f64>, tree: &Flat<f64>, rays: &[Ray<f64>]) -> usize {
    let (plain, quick) = (Oracle::new(flat), Oracle::new(tree));
    let is_changed = |ray: &&Ray<f64>| {
        let expected = plain.closest(**ray);
        let truth = quick.closest(**ray);
        // What the tree leaves out may be near, but not so near.
        let margin = expected.margin.min(2_f64.powi(-21));
        truth.margin < expected.margin
            || truth.margin.min(2_f64.powi(-21)) != margin
            // Rows stand in another order with a tree.
            || (Truth { margin, row: 0, ..truth }) != (Truth { margin, row: 0, ..expected })
    };
    rays.par_iter().filter(is_changed).count()
}

#[test]
fn a_tree_changes_nothing() {
    let crowd = crowd();
    let rays_at_crowd = crowd_rays(&crowd);
    assert_eq!(
        changed_by_tree(&crowd, &with_tree(&crowd), &rays_at_crowd),
        0
    );
    for name in ["seed-spheres", "shapes"] {
        let flat = scene(name, 60);
        let rays: Vec<_> = rays(&flat).collect();
        assert_eq!(
            changed_by_tree(&flat, &with_tree(&flat), &rays),
            0,
            "{name}"
        );
    }
    // The control: a tree that lacks a branch.
    let mut poor = with_tree(&crowd);
    let last = poor.pairs.len() - 1;
    poor.pairs[last].right = poor.pairs[last].left;
    let changed = changed_by_tree(&crowd, &poor, &rays_at_crowd);
    assert!(changed > 0, "{changed}");
}

/// From so far away that the origin's rounding to f32, in which boxes are, is larger than
/// the shapes.
#[test]
fn a_tree_is_as_good_from_afar() {
    let mut n = Numbers(11);
    let mut shapes = Shapes::none();
    let centers: Vec<_> = (0..50).map(|_| n.point(1.0)).collect();
    for center in &centers {
        shapes = shapes.sphere(*center, 1e-4);
    }
    let toward = |center: &[f64; 3]| {
        let from = n.point(1e7);
        ray(from, std::array::from_fn(|axis| center[axis] - from[axis]))
    };
    let rays: Vec<_> = centers.iter().map(toward).collect();
    assert_eq!(changed_by_tree(&shapes.0, &with_tree(&shapes.0), &rays), 0);
}

#[test]
fn the_first_candidate_is_the_closest() {
    let crowd = crowd();
    let oracle = Oracle::new(&crowd);
    let mut met = 0;
    for ray in crowd_rays(&crowd) {
        let truth = oracle.closest(ray);
        let candidates = oracle.candidates(ray);
        let first = candidates
            .first()
            .map(|one| (one.id, one.row, one.t, one.t_rest));
        let expected = (truth.id != NO_HIT).then_some((truth.id, truth.row, truth.t, truth.t_rest));
        assert_eq!(first, expected, "{ray:?}");
        assert!(candidates.is_sorted_by(|x, y| x.t <= y.t));
        met += candidates.len();
    }
    assert!(met > 5000, "{met}");
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
        } else if hit.id != NO_HIT && truth.margin > F64_MARGIN {
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

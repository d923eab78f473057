//! The bounding volume hierarchy: only what the ray comes near is tested.

use super::aabb::{Interval, clip_to_box};
use super::disks::test_disk;
use super::hit::Hit;
use super::planes::closest_plane;
use super::probe::Probe;
use super::real::Real;
use super::spheres::test_sphere;
use super::triangles::test_triangle;
use super::vector::Vec3;
use crate::flat::Flat;
use crate::layout::Pair;

/// Pairs that can wait while others are visited; the builder builds no deeper.
pub const STACK: usize = 64;

/// Pairs that a ray visits at most. A tree of any use is left long before; past
/// it the ray is given up, and said to be. Below lavapipe's 65,535 iterations.
pub const MOST_VISITS: u32 = 30_000;

/// In place of a hit's tests: the ray was given up.
pub const GIVEN_UP: u32 = u32::MAX;

/// Tests one primitive that is not a plane, by its id.
fn test_primitive<R: Real>(flat: &Flat<R>, probe: Probe<R>, id: u32, hit: &mut Hit<R>) {
    if id < flat.first_plane() {
        test_sphere(flat, probe, id, hit);
    } else if id < flat.first_triangle() {
        test_disk(flat, probe, id - flat.first_disk(), hit);
    } else {
        test_triangle(flat, probe, id - flat.first_triangle(), hit);
    }
}

/// Tests a leaf's primitives.
fn test_leaf<R: Real>(flat: &Flat<R>, probe: Probe<R>, first: u32, count: u32, hit: &mut Hit<R>) {
    for i in first..first + count {
        test_primitive(flat, probe, flat.leaf_ids[i as usize], hit);
    }
}

/// Whether something in the box may be nearer than the hit, or as near.
fn may_be_nearer<R: Real>(interval: Interval, hit: Hit<R>) -> bool {
    interval.enter <= interval.exit && R::from_f64(f64::from(interval.enter)) <= hit.t
}

/// The nearest of all primitives: of the planes, which no volume holds, then of
/// those in the tree, the nearer child of each pair first.
pub fn closest_hit<R: Real>(flat: &Flat<R>, probe: Probe<R>, hit: &mut Hit<R>) {
    closest_plane(flat, probe, hit);
    let mut waiting = [0; STACK];
    let mut entered = [0.0; STACK];
    let mut depth = 0;
    let mut at = 0;
    for _ in 0..MOST_VISITS {
        let pair: &Pair = &flat.pairs[at as usize];
        let left = clip_to_box(
            probe.slabs,
            Vec3::from(pair.left_low),
            Vec3::from(pair.left_high),
        );
        let right = clip_to_box(
            probe.slabs,
            Vec3::from(pair.right_low),
            Vec3::from(pair.right_high),
        );
        let mut to_left = may_be_nearer(left, *hit);
        let mut to_right = may_be_nearer(right, *hit);
        if to_left && pair.left_count > 0 {
            test_leaf(flat, probe, pair.left, pair.left_count, hit);
            to_left = false;
        }
        if to_right && pair.right_count > 0 {
            test_leaf(flat, probe, pair.right, pair.right_count, hit);
            to_right = false;
        }
        if to_left && to_right {
            let left_first = left.enter <= right.enter;
            waiting[depth] = if left_first { pair.right } else { pair.left };
            entered[depth] = if left_first { right.enter } else { left.enter };
            depth += 1;
            at = if left_first { pair.left } else { pair.right };
            continue;
        }
        if to_left || to_right {
            at = if to_left { pair.left } else { pair.right };
            continue;
        }
        loop {
            if depth == 0 {
                return;
            }
            depth -= 1;
            if R::from_f64(f64::from(entered[depth])) <= hit.t {
                break;
            }
        }
        at = waiting[depth];
    }
    hit.tests = GIVEN_UP;
}

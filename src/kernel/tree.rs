//! The bounding volume hierarchy: only what the ray comes near is tested.

use super::aabb::{Interval, clip_to_box};
use super::count::count_bound;
use super::doubt::limit_of;
use super::hit::{GIVEN_UP, Hit};
use super::planes::closest_plane;
use super::probe::Probe;
use super::real::{Real, constant};
use super::trace::test_rows;
use super::vector::{Vec3, vec3};
use crate::flat::Flat;
use crate::layout::{LEAF, NO_HIT, NOWHERE, Pair, leaf_parts};

/// Pairs that can wait while others are visited; the builder builds no deeper.
pub const STACK: usize = 64;

/// Pairs that a ray visits at most. A tree of any use is left long before; past
/// it the ray is given up, and said to be. Below lavapipe's 65,535 iterations.
pub const MOST_VISITS: u32 = 30_000;

/// The two children of a pair: their boxes, and what they are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Children {
    /// The left child's box.
    pub left_low: Vec3<f32>,
    /// The left child's box.
    pub left_high: Vec3<f32>,
    /// The right child's box.
    pub right_low: Vec3<f32>,
    /// The right child's box.
    pub right_high: Vec3<f32>,
    /// See [`Pair`].
    pub left: u32,
    /// See [`Pair`].
    pub right: u32,
}

/// The planes of both boxes across one axis: the left one's low and high, the right
/// one's. Origin and offset are whole steps, so nothing is rounded.
fn axis_planes(origin: u32, offsets: u32) -> [f32; 4] {
    let step = f32::from_bits((origin >> 24) << 23);
    let start = (origin << 8) as i32 >> 8;
    let offset = [offsets, offsets >> 8, offsets >> 16, offsets >> 24].map(|word| word & 255);
    offset.map(|offset| (start + offset as i32) as f32 * step)
}

/// The children of a pair.
pub fn children_of(pair: &Pair) -> Children {
    let x = axis_planes(pair.x[0], pair.x[1]);
    let y = axis_planes(pair.y[0], pair.y[1]);
    let z = axis_planes(pair.z[0], pair.z[1]);
    Children {
        left_low: vec3(x[0], y[0], z[0]),
        left_high: vec3(x[1], y[1], z[1]),
        right_low: vec3(x[2], y[2], z[2]),
        right_high: vec3(x[3], y[3], z[3]),
        left: pair.left,
        right: pair.right,
    }
}

/// Tests a leaf's primitives, which are of one kind.
fn test_leaf<R: Real>(flat: &Flat<R>, probe: Probe<R>, leaf: u32, hit: &mut Hit<R>) {
    let (kind, count, row) = leaf_parts(leaf);
    test_rows(flat, probe, kind, row..row + count, hit);
}

/// Whether something in the box may be nearer than the hit, or as near.
fn may_be_nearer<R: Real>(interval: Interval, hit: Hit<R>) -> bool {
    interval.enter <= interval.exit && constant::<R>(interval.enter) <= limit_of(hit)
}

/// The last of those that wait, or [`NOWHERE`]. It may be farther than the hit by
/// now: to visit it costs less than to keep where each is entered.
fn next_waiting(stack: &[u32; STACK], depth: &mut usize) -> u32 {
    if *depth == 0 {
        return NOWHERE;
    }
    *depth -= 1;
    stack[*depth]
}

/// Tests the boxes of a pair's children and tells where to go on: to the one that is met
/// and, if both are, to the nearer one while the other waits.
#[inline]
fn visit_pair<R: Real>(
    flat: &Flat<R>,
    probe: Probe<R>,
    at: u32,
    stack: &mut [u32; STACK],
    depth: &mut usize,
    hit: &mut Hit<R>,
) -> u32 {
    let children = children_of(&flat.pairs[at as usize]);
    let left = clip_to_box(probe.slabs, children.left_low, children.left_high);
    let right = clip_to_box(probe.slabs, children.right_low, children.right_high);
    let to_left = may_be_nearer(left, *hit);
    let to_right = may_be_nearer(right, *hit);
    count_bound(hit, to_left);
    count_bound(hit, to_right);
    let left_first = to_left && (!to_right || left.enter <= right.enter);
    let mut next = if left_first {
        children.left
    } else {
        children.right
    };
    if to_left && to_right {
        stack[*depth] = if left_first {
            children.right
        } else {
            children.left
        };
        *depth += 1;
    }
    if !(to_left || to_right) {
        next = next_waiting(stack, depth);
    }
    next
}

/// The nearest of all primitives: of the planes, which no volume holds, then of
/// those in the tree, the nearer child of each pair first.
///
/// While there are pairs, pairs; then a leaf: lanes that run together are thus
/// mostly at the same. Aila, Laine, "Understanding the Efficiency of Ray Traversal
/// on GPUs", HPG 2009, section 3.
pub fn closest_hit<R: Real>(flat: &Flat<R>, probe: Probe<R>, hit: &mut Hit<R>) {
    closest_plane(flat, probe, hit);
    let mut stack = [0; STACK];
    let mut depth = 0;
    let mut at = 0;
    let mut visits = 0;
    while at != NOWHERE && visits < MOST_VISITS {
        while (at & LEAF) == 0 && visits < MOST_VISITS {
            visits += 1;
            at = visit_pair(flat, probe, at, &mut stack, &mut depth, hit);
        }
        if at != NOWHERE && (at & LEAF) != 0 {
            test_leaf(flat, probe, at, hit);
            visits += 1;
            at = next_waiting(&stack, &mut depth);
        }
    }
    if at != NOWHERE || depth > 0 {
        hit.tests = GIVEN_UP;
    }
}

/// Whether anything is met no later than at `limit`: of shadow rays that is all there is
/// to know. The first hit ends it. A ray that is given up counts as blocked, and `tests`
/// tells.
pub fn any_hit<R: Real>(flat: &Flat<R>, probe: Probe<R>, limit: R, hit: &mut Hit<R>) -> bool {
    hit.t = limit;
    closest_plane(flat, probe, hit);
    let mut stack = [0; STACK];
    let mut depth = 0;
    let mut at = 0;
    let mut visits = 0;
    while at != NOWHERE && hit.id == NO_HIT && visits < MOST_VISITS {
        while (at & LEAF) == 0 && visits < MOST_VISITS {
            visits += 1;
            at = visit_pair(flat, probe, at, &mut stack, &mut depth, hit);
        }
        if at != NOWHERE && (at & LEAF) != 0 {
            test_leaf(flat, probe, at, hit);
            visits += 1;
            at = next_waiting(&stack, &mut depth);
        }
    }
    if hit.id != NO_HIT {
        return true;
    }
    if at != NOWHERE || depth > 0 {
        hit.tests = GIVEN_UP;
        return true;
    }
    false
}

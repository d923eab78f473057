//! The way through the tree: leaves that may hold the nearest hit, the near ones first.

use std::ops::Range;

use crate::flat::{Flat, Kind};
use crate::kernel::aabb::{Interval, clip_to_box, slabs_of};
use crate::kernel::camera::Ray;
use crate::kernel::tree::{STACK, children_of};
use crate::kernel::vector::{Vec3, vec3};
use crate::layout::{LEAF, leaf_parts};

/// By how much `enter` may be too large: the roundings of the direction, its reciprocal,
/// a difference and a product are 4 of 2^-24, this is 16.
const EARLY: f64 = 1.0 - 16.0 / 16_777_216.0;

/// Boxes are padded for rays from the camera. For others they grow by so many parts of the
/// origin's distance; its rounding to f32 takes one of 2^-24, a difference another. The end
/// of an interval is moved out by as much, so no test tells this from none; but a box that
/// is large enough is simpler to prove.
const PADDING: f64 = 64.0 / 16_777_216.0;

/// Calls `visit` for the rows of each leaf whose box the ray meets no later than at the
/// `limit`, which is then what `visit` gives.
///
/// A box holds every exact hit of what is in it with room to spare: it is padded by 32
/// parts in 2^24 of the shape's reach, and the slab test takes 5, see `docs/numerics.md`.
/// The ray's direction is to be of a length near 1.
pub fn walk(
    flat: &Flat<f64>,
    ray: Ray<f64>,
    mut limit: f64,
    mut visit: impl FnMut(Kind, Range<u32>) -> f64,
) {
    let slabs = slabs_of(ray);
    let o = ray.origin;
    let padding = (PADDING * (o.x.abs() + o.y.abs() + o.z.abs())) as f32;
    let pad = vec3(padding, padding, padding);
    let clip = |low: Vec3<f32>, high: Vec3<f32>| clip_to_box(slabs, low - pad, high + pad);
    let may_hold = |interval: Interval, limit: f64| {
        interval.enter <= interval.exit && f64::from(interval.enter) * EARLY <= limit
    };
    let mut waiting = [(0, 0.0); STACK];
    let mut depth = 0;
    let mut at = Some(0);
    while let Some(child) = at {
        at = None;
        if child & LEAF != 0 {
            let (kind, count, row) = leaf_parts(child);
            limit = visit(kind_of(kind), row..row + count);
        } else {
            let pair = children_of(&flat.pairs[child as usize]);
            let left = clip(pair.left_low, pair.left_high);
            let right = clip(pair.right_low, pair.right_high);
            let mut children = [(pair.left, left), (pair.right, right)];
            if right.enter < left.enter {
                children.swap(0, 1);
            }
            let [near, far] = children;
            if may_hold(far.1, limit) {
                waiting[depth] = (far.0, far.1.enter);
                depth += 1;
            }
            if may_hold(near.1, limit) {
                at = Some(near.0);
            }
        }
        while at.is_none() && depth > 0 {
            depth -= 1;
            let (child, enter) = waiting[depth];
            if f64::from(enter) * EARLY <= limit {
                at = Some(child);
            }
        }
    }
}

fn kind_of(kind: u32) -> Kind {
    match kind {
        0 => Kind::Sphere,
        1 => Kind::Disk,
        _ => Kind::Triangle,
    }
}

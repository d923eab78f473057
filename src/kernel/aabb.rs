//! Axis-aligned boxes, in f32 in every width of the geometry.
//!
//! A box that holds another one holds the ray's interval there too, with no allowance
//! for rounding: each bound is a rounded difference times a rounded reciprocal, and both
//! are monotone. See `docs/numerics.md`.

use super::camera::Ray;
use super::divide::divide;
use super::own_box::{padding, slack};
use super::real::Real;
use super::vector::{Vec3, taxicab_length, vec3};

/// Stands for the reciprocal of zero: larger than that of any component that
/// matters, and finite, so that 0 times it is 0.
pub const HUGE: f32 = 1e30;

/// Rays that start farther from the camera meet no box: a scene reaches 2e15 at most, and
/// boxes would be wider than that.
pub const FARTHEST: f32 = 1e21;

/// The bits of the largest finite number.
const GREATEST_BITS: u32 = 0x7f7f_ffff;

/// All points from `low` to `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aabb {
    /// The smallest coordinates.
    pub low: Vec3<f32>,
    /// The largest coordinates.
    pub high: Vec3<f32>,
}

/// What the slab test needs of a ray.
#[derive(Debug, Clone, Copy)]
pub struct Slabs {
    /// Where the ray starts, moved up by what boxes are to be wider for it: what low
    /// planes are measured from.
    pub above: Vec3<f32>,
    /// The same, moved down.
    pub below: Vec3<f32>,
    /// One over each component of its direction.
    pub inverse: Vec3<f32>,
    /// By how much an interval's end is moved out.
    pub slack: f32,
}

/// The values of t between which a ray is in a box; none if `enter` > `exit`.
#[derive(Debug, Clone, Copy)]
pub struct Interval {
    /// At least 0.
    pub enter: f32,
    /// See `enter`.
    pub exit: f32,
}

/// 1 / component, but finite.
fn reciprocal(component: f32) -> f32 {
    if component.abs() < 1.0 / HUGE {
        return if component < 0.0 { -HUGE } else { HUGE };
    }
    divide(1.0, component)
}

/// Whether rays of such a length, from so far away, can be traced: no number of theirs is
/// infinite or none at all, and the length is not 0. Told by the bits, since WGSL lets a
/// compiler take it that there are no such numbers.
fn leads_somewhere(distance: f32, length: f32) -> bool {
    distance.to_bits() <= FARTHEST.to_bits() && length.to_bits().wrapping_sub(1) < GREATEST_BITS
}

/// The slabs of a ray that leads nowhere: all boxes are behind it.
fn slabs_of_nothing<R: Real>() -> Slabs {
    let past_all = vec3(FARTHEST, FARTHEST, FARTHEST);
    Slabs {
        above: past_all,
        below: past_all,
        inverse: vec3(1.0, 1.0, 1.0),
        slack: slack::<R>(),
    }
}

/// The ray's slabs. Boxes are padded for rays from the camera; for one that starts
/// elsewhere they are wider by as much of its origin's distance.
pub fn slabs_of<R: Real>(ray: Ray<R>) -> Slabs {
    let d = ray.direction.to_f32();
    let o = ray.origin.to_f32();
    let distance = taxicab_length(o);
    if !leads_somewhere(distance, taxicab_length(d)) {
        return slabs_of_nothing::<R>();
    }
    let margin = distance * padding::<R>();
    let wider = vec3(margin, margin, margin);
    Slabs {
        above: o + wider,
        below: o - wider,
        inverse: vec3(reciprocal(d.x), reciprocal(d.y), reciprocal(d.z)),
        slack: slack::<R>(),
    }
}

/// The smaller of two numbers.
pub fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The larger of two numbers.
pub fn greatest(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Where the ray is in the box, after t = 0.
pub fn clip_to_box(slabs: Slabs, low: Vec3<f32>, high: Vec3<f32>) -> Interval {
    let to_low = (low - slabs.above).times(slabs.inverse);
    let to_high = (high - slabs.below).times(slabs.inverse);
    let enter_xy = greatest(least(to_low.x, to_high.x), least(to_low.y, to_high.y));
    let exit_xy = least(greatest(to_low.x, to_high.x), greatest(to_low.y, to_high.y));
    let enter = greatest(enter_xy, least(to_low.z, to_high.z));
    let exit = least(exit_xy, greatest(to_low.z, to_high.z));
    Interval {
        enter: greatest(enter, 0.0),
        exit: exit * slabs.slack,
    }
}

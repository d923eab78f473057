//! Axis-aligned boxes, in f32 in every width of the geometry.
//!
//! A hit counts only where the ray also meets the shape's own box, and its t is
//! clamped to the ray's interval there. A box that holds the shape's box holds
//! the interval too, with no allowance for rounding: each bound is a rounded
//! difference times a rounded reciprocal, and both are monotone. So no volume
//! can lose a hit, see `docs/numerics.md`.

use super::camera::Ray;
use super::divide::divide;
use super::real::Real;
use super::vector::{Vec3, vec3};

/// A box's padding in parts of its shape's distance from the camera: above the
/// error with which any shape test accepts a ray, which is at most 16 roundings
/// of 2^-24 of that distance.
pub const PADDING: f32 = 32.0 / 16_777_216.0;

/// By how much an interval's end is moved out: above the three roundings of 2^-24
/// of a slab test. Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013.
pub const SLACK: f32 = 1.000_000_5;

/// Stands for the reciprocal of zero: larger than that of any component that
/// matters, and finite, so that 0 times it is 0.
pub const HUGE: f32 = 1e30;

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
    /// Where the ray starts.
    pub origin: Vec3<f32>,
    /// One over each component of its direction.
    pub inverse: Vec3<f32>,
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
        return super::real::copy_sign(HUGE, component);
    }
    divide(1.0, component)
}

/// The ray's slabs.
pub fn slabs_of<R: Real>(ray: Ray<R>) -> Slabs {
    let d = ray.direction.to_f32();
    Slabs {
        origin: ray.origin.to_f32(),
        inverse: vec3(reciprocal(d.x), reciprocal(d.y), reciprocal(d.z)),
    }
}

/// The smaller of two numbers.
fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The larger of two numbers.
fn greatest(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Where the ray is in the box, after t = 0.
pub fn clip_to_box(slabs: Slabs, low: Vec3<f32>, high: Vec3<f32>) -> Interval {
    let to_low = (low - slabs.origin).times(slabs.inverse);
    let to_high = (high - slabs.origin).times(slabs.inverse);
    let enter_xy = greatest(least(to_low.x, to_high.x), least(to_low.y, to_high.y));
    let exit_xy = least(greatest(to_low.x, to_high.x), greatest(to_low.y, to_high.y));
    let enter = greatest(enter_xy, least(to_low.z, to_high.z));
    let exit = least(exit_xy, greatest(to_low.z, to_high.z));
    Interval {
        enter: greatest(enter, 0.0),
        exit: exit * SLACK,
    }
}

/// The box from `low` to `high`, padded for a shape whose points lie within
/// `reach` of the camera.
fn padded_box(low: Vec3<f32>, high: Vec3<f32>, reach: f32) -> Aabb {
    let padding = reach * PADDING;
    let pad = vec3(padding, padding, padding);
    Aabb {
        low: low - pad,
        high: high + pad,
    }
}

/// The box of the points within `radius` of `center`: of a sphere or a disk.
pub fn ball_box(center: Vec3<f32>, radius: f32) -> Aabb {
    let corner = vec3(radius, radius, radius);
    let reach = ((center.x.abs() + center.y.abs()) + center.z.abs()) + radius;
    padded_box(center - corner, center + corner, reach)
}

/// The box of a triangle.
pub fn triangle_box(a: Vec3<f32>, b: Vec3<f32>, c: Vec3<f32>) -> Aabb {
    let low = vec3(
        least(least(a.x, b.x), c.x),
        least(least(a.y, b.y), c.y),
        least(least(a.z, b.z), c.z),
    );
    let high = vec3(
        greatest(greatest(a.x, b.x), c.x),
        greatest(greatest(a.y, b.y), c.y),
        greatest(greatest(a.z, b.z), c.z),
    );
    let reach_x = greatest(low.x.abs(), high.x.abs());
    let reach_y = greatest(low.y.abs(), high.y.abs());
    let reach_z = greatest(low.z.abs(), high.z.abs());
    padded_box(low, high, (reach_x + reach_y) + reach_z)
}

/// t, clamped to where the ray is in the shape's own box, or `MISS`.
pub fn clamp_to_box<R: Real>(slabs: Slabs, own: Aabb, t: R) -> R {
    let interval = clip_to_box(slabs, own.low, own.high);
    if interval.enter > interval.exit {
        return R::MISS;
    }
    let enter = R::from_f64(f64::from(interval.enter));
    let exit = R::from_f64(f64::from(interval.exit));
    if t < enter {
        return enter;
    }
    if t > exit {
        return exit;
    }
    t
}

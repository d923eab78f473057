//! The box of each shape, a part of its test.
//!
//! A hit counts only where the ray also meets the shape's own box, and its t is
//! clamped to the ray's interval there. So no volume can lose a hit, see
//! `docs/numerics.md`.

use super::aabb::{Aabb, Slabs, clip_to_box, greatest, least};
use super::real::{Real, constant};
use super::vector::{Vec3, vec3};
use crate::tier::Formulas;

/// A box's padding in parts of its shape's distance from the camera: above the
/// error with which any shape test accepts a ray, which is at most 16 roundings
/// of 2^-24 of that distance.
pub const PADDING: f32 = 32.0 / 16_777_216.0;

/// By how much an interval's end is moved out: above the three roundings of 2^-24
/// of a slab test. Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013.
pub const SLACK: f32 = 1.000_000_5;

/// A box's padding in parts of its shape's distance; the textbook has none.
pub fn padding<R: Real>() -> f32 {
    if R::FORMULAS == Formulas::Textbook {
        0.0
    } else {
        PADDING
    }
}

/// By how much an interval's end is moved out; in a textbook, it is not.
pub fn slack<R: Real>() -> f32 {
    if R::FORMULAS == Formulas::Textbook {
        1.0
    } else {
        SLACK
    }
}

/// The box from `low` to `high`, padded for a shape whose points lie within
/// `reach` of the camera.
pub fn padded_box<R: Real>(low: Vec3<f32>, high: Vec3<f32>, reach: f32) -> Aabb {
    let padding = reach * padding::<R>();
    let pad = vec3(padding, padding, padding);
    Aabb {
        low: low - pad,
        high: high + pad,
    }
}

/// The box of the points within `radius` of `center`: of a sphere or a disk.
pub fn ball_box<R: Real>(center: Vec3<f32>, radius: f32) -> Aabb {
    let corner = vec3(radius, radius, radius);
    let reach = ((center.x.abs() + center.y.abs()) + center.z.abs()) + radius;
    padded_box::<R>(center - corner, center + corner, reach)
}

/// The box of a triangle.
pub fn triangle_box<R: Real>(a: Vec3<f32>, b: Vec3<f32>, c: Vec3<f32>) -> Aabb {
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
    padded_box::<R>(low, high, (reach_x + reach_y) + reach_z)
}

/// t, clamped to where the ray is in the shape's own box, or `MISS`. The textbook has no
/// such thing: there, a tree may lose a hit.
pub fn clamp_to_box<R: Real>(slabs: Slabs, own: Aabb, t: R) -> R {
    if R::FORMULAS == Formulas::Textbook {
        return t;
    }
    let interval = clip_to_box(slabs, own.low, own.high);
    if interval.enter > interval.exit {
        return R::MISS;
    }
    let enter = constant(interval.enter);
    let exit = constant(interval.exit);
    if t < enter {
        return enter;
    }
    if t > exit {
        return exit;
    }
    t
}

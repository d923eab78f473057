//! A lens: what is not at its focus is out of focus.
//!
//! Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984: a thin lens bends all rays
//! through it that belong to a point of the picture to one point of the plane in focus.

use super::camera::Ray;
use super::circle::disk_point;
use super::dimensions::IN_LENS;
use super::numbers::{Numbers, number_pair};
use super::real::Real;
use super::vector::Vec3;
use crate::flat::Flat;

/// A ray of the camera through the sample's place on the lens.
pub fn through_lens<R: Real>(flat: &Flat<R>, ray: Ray<R>, numbers: Numbers) -> Ray<R> {
    let lens = &flat.lens;
    if lens.radius == 0.0 {
        return ray;
    }
    let [x, y] = disk_point(number_pair(numbers, IN_LENS));
    let aside = Vec3::from(lens.right) * x + Vec3::from(lens.up) * y;
    let turn = Vec3::from(lens.turn_right) * x + Vec3::from(lens.turn_up) * y;
    Ray {
        origin: ray.origin + aside.widened(),
        direction: ray.direction - turn.widened(),
    }
}

//! Shapes and a camera that move while the shutter is open.
//!
//! Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984: each sample sees them as
//! they are at a time of its own.

use super::camera::Ray;
use super::dimensions::IN_TIME;
use super::numbers::{Numbers, number};
use super::real::Real;
use super::tracer::Tracer;
use super::vector::Vec3;
use crate::flat::Flat;

/// When a sample is taken: -1/2 as the shutter opens, below 1/2 as it closes.
pub fn shutter_time(numbers: Numbers) -> f32 {
    number(numbers, IN_TIME) - 0.5
}

/// Has the shapes stand where they are at the sample's time.
pub fn open_shutter<R: Real>(flat: &Flat<R>, tracer: &mut impl Tracer<R>, numbers: Numbers) {
    if flat.has_moving_shapes() {
        tracer.open_shutter(shutter_time(numbers));
    }
}

/// A ray of the camera from where it is at the sample's time.
pub fn from_moving_camera<R: Real>(flat: &Flat<R>, ray: Ray<R>, numbers: Numbers) -> Ray<R> {
    if flat.camera_velocity == [0.0; 3] {
        return ray;
    }
    let way = Vec3::from(flat.camera_velocity) * shutter_time(numbers);
    Ray {
        origin: ray.origin + way.widened(),
        direction: ray.direction,
    }
}

/// Where a place of the primitive `id` is at a time.
pub fn moved<R: Real>(flat: &Flat<R>, place: Vec3<R>, id: u32, time: f32) -> Vec3<R> {
    match flat.velocity_of(id) {
        None => place,
        Some(velocity) => place + (Vec3::from(velocity) * time).widened(),
    }
}

//! A pixel's samples go through it all over, not through one point.

use super::camera::Ray;
use super::dimensions::IN_PIXEL;
use super::divide::divide;
use super::numbers::{Numbers, number_pair};
use super::real::{Real, constant};
use super::vector::Vec3;
use crate::flat::Flat;

/// A ray of the camera, moved to the sample's place in the pixel.
pub fn in_pixel<R: Real>(flat: &Flat<R>, ray: Ray<R>, numbers: Numbers) -> Ray<R> {
    let [x, y] = number_pair(numbers, IN_PIXEL);
    let spread = flat.sampling.spread;
    // In halves of the picture's size, as the camera's axes reach from its middle to its edges.
    let right = divide(2.0 * spread * (x - 0.5), flat.size[0] as f32);
    let down = divide(2.0 * spread * (y - 0.5), flat.size[1] as f32);
    let across = Vec3::from(flat.camera.right) * constant(right);
    let along = Vec3::from(flat.camera.up) * constant(down);
    Ray {
        origin: ray.origin,
        direction: ray.direction + across - along,
    }
}

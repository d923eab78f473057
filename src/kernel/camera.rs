//! From a pixel to its ray.

use super::divide::divide;
use super::real::Real;
use super::vector::{Vec3, vec3};
use crate::layout::CameraRecord;

/// The points `origin` + t * `direction`, t > 0. The direction has any length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray<R> {
    /// Where the ray starts, relative to the camera.
    pub origin: Vec3<R>,
    /// Where it goes.
    pub direction: Vec3<R>,
}

impl<R: Real> Ray<R> {
    /// The same ray in numbers of another kind.
    pub fn converted<S: Real>(self) -> Ray<S> {
        let convert = |v: Vec3<R>| {
            let [x, y, z] = <[R; 3]>::from(v).map(|number| S::from_f64(number.to_f64()));
            vec3(x, y, z)
        };
        Ray {
            origin: convert(self.origin),
            direction: convert(self.direction),
        }
    }
}

/// `at` as a fraction of half the size: -1 at the near edge, 1 at the far edge.
///
/// `pixel` + `offset` and the difference below are exact for sizes under 2^23,
/// so the division is the only rounding.
fn screen_coordinate<R: Real>(pixel: u32, offset: R, size: u32) -> R {
    let at = R::TWO * (R::from_u32(pixel) + offset);
    let size = R::from_u32(size);
    divide(at - size, size)
}

/// The ray through pixel (x, y), y downward from the top row. The scene is
/// camera-relative, so the origin is zero.
pub fn camera_ray<R: Real>(camera: &CameraRecord<R>, size: [u32; 2], x: u32, y: u32) -> Ray<R> {
    let sx = screen_coordinate(x, camera.offset_x, size[0]);
    let sy = screen_coordinate(y, camera.offset_y, size[1]);
    let across = Vec3::from(camera.right) * sx - Vec3::from(camera.up) * sy;
    Ray {
        origin: vec3(R::ZERO, R::ZERO, R::ZERO),
        direction: across + Vec3::from(camera.forward),
    }
}

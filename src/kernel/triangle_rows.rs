//! Triangles, where they are at a time. Those that share a vertex go the same way, so it is
//! rounded alike for each of them, and a mesh stays watertight.

use super::motion::moved;
use super::real::Real;
use super::triangles::triangle_of;
use super::vector::Vec3;
use crate::flat::Flat;
use crate::layout::{Corners, Triangle};

/// The triangle with these corners.
#[inline]
pub fn triangle_at<R: Real>(flat: &Flat<R>, corners: Corners, time: f32) -> Triangle<R> {
    let triangle = triangle_of(flat, corners);
    if !flat.has_moving_shapes() {
        return triangle;
    }
    let at_time = |corner| moved(flat, Vec3::from(corner), corners.id, time).into();
    Triangle {
        a: at_time(triangle.a),
        b: at_time(triangle.b),
        c: at_time(triangle.c),
        ..triangle
    }
}

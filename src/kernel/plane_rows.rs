//! Planes, where they are at a time.

use super::motion::moved;
use super::real::Real;
use crate::flat::Flat;
use crate::layout::Plane;

/// The plane in a row of the table.
#[inline]
pub fn plane_at<R: Real>(flat: &Flat<R>, row: u32, time: f32) -> Plane<R> {
    let mut plane = flat.planes[row as usize];
    let id = flat.first_plane() + row;
    plane.point = moved(flat, plane.point.into(), id, time).into();
    plane
}

//! Spheres, where they are at a time.

use super::motion::moved;
use super::real::Real;
use crate::flat::Flat;
use crate::layout::Sphere;

/// The sphere in a row of the table.
#[inline]
pub fn sphere_at<R: Real>(flat: &Flat<R>, row: u32, time: f32) -> Sphere<R> {
    let mut sphere = flat.spheres[row as usize];
    if flat.has_moving_shapes() {
        let id = flat.sphere_ids[row as usize];
        sphere.center = moved(flat, sphere.center.into(), id, time).into();
    }
    sphere
}

//! All planes: which one is nearest, and what is found there.

use super::camera::Ray;
use super::hit::{Hit, Surface, count_test, keep_nearer, may_be_closest};
use super::plane::intersect_plane;
use super::probe::Probe;
use super::real::Real;
use super::vector::{Vec3, face_viewer};
use crate::flat::Flat;

/// Tests every plane.
pub fn closest_plane<R: Real>(flat: &Flat<R>, probe: Probe<R>, hit: &mut Hit<R>) {
    for (plane, row) in flat.planes.iter().zip(0..) {
        let t = intersect_plane(probe.ray, Vec3::from(plane.point), Vec3::from(plane.normal));
        count_test(hit);
        if may_be_closest(*hit, t) {
            keep_nearer(hit, t, flat.first_plane() + row, row);
        }
    }
}

/// The surface of the plane that was hit.
pub fn plane_surface<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Option<Surface> {
    if hit.id < flat.first_plane() || hit.id >= flat.first_disk() {
        return None;
    }
    let plane = &flat.planes[hit.row as usize];
    Some(Surface {
        position: (ray.origin + ray.direction * hit.t).to_f32(),
        normal: face_viewer(Vec3::from(plane.normal), ray.direction).to_f32(),
    })
}

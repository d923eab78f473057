//! All spheres: which one is nearest, and what is found there.

use std::ops::Range;

use super::aabb::{ball_box, clamp_to_box};
use super::camera::Ray;
use super::hit::{Hit, Surface, count_test, keep_nearer, may_be_closest};
use super::probe::Probe;
use super::real::Real;
use super::sphere::{intersect_sphere, sphere_normal, sphere_point};
use super::vector::{Vec3, face_viewer};
use crate::flat::Flat;

/// Tests the sphere in a row of the table, within its own box.
#[inline]
pub fn test_sphere<R: Real>(flat: &Flat<R>, probe: Probe<R>, row: u32, hit: &mut Hit<R>) {
    let sphere = &flat.spheres[row as usize];
    let mut t = intersect_sphere(probe.ray, sphere);
    count_test(hit);
    if t < R::MISS {
        t = clamp_to_box(
            probe.slabs,
            ball_box(Vec3::from(sphere.center).to_f32(), sphere.radius.to_f32()),
            t,
        );
        if may_be_closest(*hit, t) {
            keep_nearer(hit, t, flat.sphere_ids[row as usize], row);
        }
    }
}

/// Tests the spheres in some rows.
pub fn test_spheres<R: Real>(flat: &Flat<R>, probe: Probe<R>, rows: Range<u32>, hit: &mut Hit<R>) {
    for row in rows {
        test_sphere(flat, probe, row, hit);
    }
}

/// The surface of the sphere that was hit.
pub fn sphere_surface<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Option<Surface> {
    if hit.id >= flat.first_plane() {
        return None;
    }
    let sphere = &flat.spheres[hit.row as usize];
    let normal = sphere_normal(ray, sphere, hit.t);
    Some(Surface {
        position: sphere_point(sphere, normal).to_f32(),
        normal: face_viewer(normal, ray.direction).to_f32(),
    })
}

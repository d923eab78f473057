//! All disks: which one is nearest, and what is found there.

use std::ops::Range;

use super::aabb::{ball_box, clamp_to_box};
use super::camera::Ray;
use super::disk::intersect_disk;
use super::hit::{Hit, Surface, count_test, keep_nearer, may_be_closest};
use super::probe::Probe;
use super::real::Real;
use super::vector::{Vec3, face_viewer};
use crate::flat::Flat;

/// Tests the disk in a row of the table, within its own box.
#[inline]
pub fn test_disk<R: Real>(flat: &Flat<R>, probe: Probe<R>, row: u32, hit: &mut Hit<R>) {
    let disk = &flat.disks[row as usize];
    let mut t = intersect_disk(probe.ray, disk);
    count_test(hit);
    if t < R::MISS {
        t = clamp_to_box(
            probe.slabs,
            ball_box(Vec3::from(disk.center).to_f32(), disk.radius.to_f32()),
            t,
        );
        if may_be_closest(*hit, t) {
            keep_nearer(hit, t, flat.disk_ids[row as usize], row);
        }
    }
}

/// Tests the disks in some rows.
pub fn test_disks<R: Real>(flat: &Flat<R>, probe: Probe<R>, rows: Range<u32>, hit: &mut Hit<R>) {
    for row in rows {
        test_disk(flat, probe, row, hit);
    }
}

/// The surface of the disk that was hit.
pub fn disk_surface<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Option<Surface> {
    if hit.id < flat.first_disk() || hit.id >= flat.first_triangle() {
        return None;
    }
    let disk = &flat.disks[hit.row as usize];
    Some(Surface {
        position: (ray.origin + ray.direction * hit.t).to_f32(),
        normal: face_viewer(Vec3::from(disk.normal), ray.direction).to_f32(),
    })
}

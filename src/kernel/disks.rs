//! All disks: which one is nearest, and what is found there.

use std::ops::Range;

use super::camera::Ray;
use super::disk_rows::disk_at;
use super::doubt::{keep_nearer, may_be_closest};
use super::hit::{Hit, Surface, count_test};
use super::probe::Probe;
use super::real::Real;
use super::vector::{Vec3, dot_product, face_viewer, taxicab_length};
use super::{disk_bounded, disk_meeting};
use crate::flat::Flat;
use crate::tier::Formulas;

/// Tests the disk in a row of the table.
#[inline]
pub fn test_disk<R: Real>(flat: &Flat<R>, probe: Probe<R>, row: u32, hit: &mut Hit<R>) {
    let disk = &disk_at(flat, row, hit.time);
    let meeting = match R::FORMULAS {
        Formulas::Bounded => disk_bounded::meet_disk(probe, disk),
        _ => disk_meeting::meet_disk(probe, disk),
    };
    count_test(hit);
    if may_be_closest(*hit, meeting) {
        keep_nearer(hit, meeting, flat.disk_ids[row as usize], row);
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
    let disk = &disk_at(flat, hit.row, hit.time);
    let facing = face_viewer(Vec3::from(disk.normal), ray.direction).to_f32();
    let reach = taxicab_length(Vec3::from(disk.center).to_f32()) + disk.radius.to_f32();
    Some(Surface {
        position: (ray.origin + ray.direction * hit.t).to_f32(),
        normal: facing,
        facing,
        reach: reach + taxicab_length(ray.origin.to_f32()),
    })
}

/// Whether the ray comes to the disk that it hit from behind.
pub fn disk_is_left<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> bool {
    if hit.id < flat.first_disk() || hit.id >= flat.first_triangle() {
        return false;
    }
    let normal = Vec3::from(flat.disks[hit.row as usize].normal);
    dot_product(normal, ray.direction) > R::ZERO
}

//! All disks: which one is nearest, and what is found there.

use super::camera::Ray;
use super::disk::intersect_disk;
use super::hit::{Hit, Surface, keep_nearer};
use super::real::Real;
use super::vector::{Vec3, face_viewer};
use crate::flat::Flat;

/// Tests every disk.
pub fn closest_disk<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: &mut Hit<R>) {
    for (disk, id) in flat.disks.iter().zip(flat.first_disk()..) {
        keep_nearer(hit, intersect_disk(ray, disk), id);
    }
}

/// The surface of the disk that was hit.
pub fn disk_surface<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Option<Surface> {
    let index = hit.id.wrapping_sub(flat.first_disk());
    let disk = flat.disks.get(index as usize)?;
    Some(Surface {
        position: (ray.origin + ray.direction * hit.t).to_f32(),
        normal: face_viewer(Vec3::from(disk.normal), ray.direction).to_f32(),
    })
}

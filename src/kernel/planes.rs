//! All planes: which one is nearest, and what is found there.

use super::camera::Ray;
use super::doubt::{keep_nearer, may_be_closest};
use super::hit::{Hit, Surface, count_test};
use super::plane_rows::plane_at;
use super::probe::Probe;
use super::real::Real;
use super::vector::{Vec3, dot_product, face_viewer, taxicab_length};
use super::{plane_bounded, plane_meeting};
use crate::flat::Flat;
use crate::tier::Formulas;

/// Tests every plane.
pub fn closest_plane<R: Real>(flat: &Flat<R>, probe: Probe<R>, hit: &mut Hit<R>) {
    for row in 0..flat.planes.len() as u32 {
        let plane = &plane_at(flat, row, hit.time);
        let meeting = match R::FORMULAS {
            Formulas::Bounded => plane_bounded::meet_plane(probe, plane),
            _ => plane_meeting::meet_plane(probe, plane),
        };
        count_test(hit);
        if may_be_closest(*hit, meeting) {
            keep_nearer(hit, meeting, flat.first_plane() + row, row);
        }
    }
}

/// The surface of the plane that was hit.
pub fn plane_surface<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Option<Surface> {
    if hit.id < flat.first_plane() || hit.id >= flat.first_disk() {
        return None;
    }
    let plane = &plane_at(flat, hit.row, hit.time);
    let position = (ray.origin + ray.direction * hit.t).to_f32();
    let facing = face_viewer(Vec3::from(plane.normal), ray.direction).to_f32();
    let reach = taxicab_length(position);
    Some(Surface {
        position,
        normal: facing,
        facing,
        reach: reach + taxicab_length(ray.origin.to_f32()),
    })
}

/// Whether the ray comes to the plane that it hit from behind.
pub fn plane_is_left<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> bool {
    if hit.id < flat.first_plane() || hit.id >= flat.first_disk() {
        return false;
    }
    let normal = Vec3::from(flat.planes[hit.row as usize].normal);
    dot_product(normal, ray.direction) > R::ZERO
}

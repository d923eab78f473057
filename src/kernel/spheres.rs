//! All spheres: which one is nearest, and what is found there.

use std::ops::Range;

use super::camera::Ray;
use super::doubt::{keep_nearer, may_be_closest};
use super::hit::{Hit, Surface, count_test};
use super::near_spheres::{sphere_power, starts_near};
use super::probe::Probe;
use super::real::Real;
use super::sphere_rows::sphere_at;
use super::vector::{Vec3, dot_product, face_viewer, taxicab_length};
use super::{sphere, sphere_bounded, sphere_meeting, sphere_textbook};
use crate::flat::Flat;
use crate::tier::Formulas;

/// Near the surface of a large sphere, what of its radius counts as its reach: roundings are
/// parts of the way to the point, and only the squares of roundings of the radius.
pub const NEAR_REACH: f32 = 1.0 / 1_048_576.0;

/// Tests the sphere in a row of the table.
#[inline]
pub fn test_sphere<R: Real>(flat: &Flat<R>, probe: Probe<R>, row: u32, hit: &mut Hit<R>) {
    let sphere = &sphere_at(flat, row, hit.time);
    let meeting = match R::FORMULAS {
        Formulas::Bounded => sphere_bounded::meet_sphere(probe, sphere),
        _ => sphere_meeting::meet_sphere(probe, sphere),
    };
    count_test(hit);
    if may_be_closest(*hit, meeting) {
        keep_nearer(hit, meeting, flat.sphere_ids[row as usize], row);
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
    let sphere = &sphere_at(flat, hit.row, hit.time);
    let (normal, position) = match R::FORMULAS {
        Formulas::Textbook => {
            let normal = sphere_textbook::sphere_normal(ray, sphere, hit.t);
            let point = sphere_textbook::sphere_point(ray, sphere, normal, hit.t);
            (normal, point)
        }
        _ => {
            let normal = sphere::sphere_normal(ray, sphere, hit.t);
            (normal, sphere::sphere_point(ray, sphere, normal, hit.t))
        }
    };
    let facing = face_viewer(normal, ray.direction).to_f32();
    let position = position.to_f32();
    let radius = sphere.radius.to_f32();
    let mut reach = taxicab_length(Vec3::from(sphere.center).to_f32()) + radius;
    if starts_near(sphere, sphere_power(ray.origin, sphere)) {
        reach = taxicab_length(position) + radius * NEAR_REACH;
    }
    Some(Surface {
        position,
        normal: facing,
        facing,
        reach: reach + taxicab_length(ray.origin.to_f32()),
    })
}

/// Whether the ray comes to the sphere that it hit from within.
pub fn sphere_is_left<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> bool {
    if hit.id >= flat.first_plane() {
        return false;
    }
    let sphere = &sphere_at(flat, hit.row, hit.time);
    let normal = match R::FORMULAS {
        Formulas::Textbook => sphere_textbook::sphere_normal(ray, sphere, hit.t),
        _ => sphere::sphere_normal(ray, sphere, hit.t),
    };
    dot_product(normal, ray.direction) > R::ZERO
}

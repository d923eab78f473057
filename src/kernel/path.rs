//! A path: from the surface that a ray meets, the next ray.

use super::camera::Ray;
use super::hit::{Hit, Surface};
use super::mirror::mirrored;
use super::offset::leave_surface;
use super::real::Real;
use super::refract::refracted;
use super::trace::surface_of;
use super::vector::{Vec3, taxicab_length};
use crate::flat::Flat;
use crate::layout::NO_HIT;

/// The kind of an aim: thrown back as by a mirror.
pub const MIRRORED: f32 = 0.0;

/// The kind of an aim: in a given direction.
pub const TOWARDS: f32 = 1.0;

/// The kind of an aim: to a given point, which is at t = 1.
pub const TO: f32 = 2.0;

/// The kind of an aim: refracted, by a given ratio of indices.
pub const REFRACTED: f32 = 3.0;

/// Where a path goes on from a surface.
#[derive(Debug, Clone, Copy)]
pub struct AimRecord {
    /// The direction, the point, or the ratio in x.
    pub vector: Vec3<f32>,
    /// Which of these.
    pub kind: f32,
}

/// The largest number: of rays whose numbers would be larger, a path goes nowhere.
pub const LARGEST: f32 = f32::MAX;

/// Whether a path has come to its end: it goes nowhere.
pub fn is_over<R: Real>(ray: Ray<R>) -> bool {
    taxicab_length(ray.direction.to_f32()) == 0.0
}

/// The direction in which a path leaves the surface that it met in `direction`.
pub fn leaving_direction(aim: AimRecord, surface: &Surface, direction: Vec3<f32>) -> Vec3<f32> {
    if aim.kind == TOWARDS {
        return aim.vector;
    }
    if aim.kind == TO {
        return aim.vector - surface.position;
    }
    if aim.kind == REFRACTED {
        return refracted(direction, surface.facing, aim.vector.x);
    }
    mirrored(direction, surface.facing)
}

/// The ray that leaves the surface that a ray met, its numbers those of f32 in every width;
/// one that goes nowhere where the ray met nothing.
pub fn next_ray<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>, aim: AimRecord) -> Ray<R> {
    let nowhere = Ray {
        origin: ray.origin,
        direction: Vec3::default(),
    };
    if hit.id == NO_HIT {
        return nowhere;
    }
    let surface = surface_of(flat, ray, hit);
    let mut direction = leaving_direction(aim, &surface, ray.direction.to_f32());
    let origin = leave_surface::<R>(surface.position, surface.facing, direction, surface.reach);
    if aim.kind == TO {
        direction = aim.vector - origin;
    }
    // So that no number is none either.
    let is_sound = taxicab_length(origin) + taxicab_length(direction) <= LARGEST;
    if !is_sound {
        return nowhere;
    }
    Ray { origin, direction }.converted()
}

//! Holes in shapes: where a texture's alpha is small, there is nothing.

use super::camera::Ray;
use super::hit::{Hit, NO_TILE, Surface, no_hit};
use super::integrator::{Path, way_to_hit};
use super::offset::leave_surface;
use super::probe::probe_of;
use super::real::{Real, constant};
use super::sources::ENDLESS;
use super::textures::{texture_color, texture_coordinates};
use super::trace::surface_of;
use super::tracer::Tracer;
use super::vector::{Vec3, dot_product};
use crate::flat::Flat;
use crate::layout::NO_HIT;

/// A ray goes through so many holes at most; what comes then is solid, so that a search ends.
pub const MOST_HOLES: u32 = 64;

/// Below this alpha there is a hole.
pub const SOLID_ALPHA: f32 = 0.5;

/// Whether a primitive may have holes.
fn has_holes<R: Real>(flat: &Flat<R>, id: u32) -> bool {
    let material = flat.material_indices[id as usize];
    flat.finishes[material as usize].is_cutout != 0
}

/// Whether there is a hole where a primitive was hit that may have some.
fn is_hole<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>, surface: &Surface) -> bool {
    let material = flat.material_indices[hit.id as usize];
    let index = flat.finishes[material as usize].texture;
    let texture = &flat.textures[index as usize];
    let coordinates = texture_coordinates(flat, ray, hit, surface, texture);
    texture_color(flat, texture, coordinates)[3] < SOLID_ALPHA
}

/// What the path's ray meets first that is no hole. Behind a hole the ray begins anew, and the
/// path knows how far it has come.
pub fn seen_hit<R: Real>(
    flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    path: &mut Path<R>,
) -> Hit<R> {
    path.passed = 0.0;
    let mut hit = no_hit();
    for hole in 0..=MOST_HOLES {
        hit = no_hit();
        hit.tile = NO_TILE;
        tracer.closest(probe_of(path.ray), &mut hit);
        if hit.id == NO_HIT || hole == MOST_HOLES || !has_holes(flat, hit.id) {
            break;
        }
        let surface = surface_of(flat, path.ray, hit);
        if !is_hole(flat, path.ray, hit, &surface) {
            break;
        }
        path.passed = way_to_hit(path, hit);
        let direction = path.ray.direction.to_f32();
        let origin = leave_surface::<R>(surface.position, surface.facing, direction, surface.reach);
        let anew: Ray<R> = Ray { origin, direction }.converted();
        path.ray.origin = anew.origin;
    }
    hit
}

/// Whether a ray meets anything no later than at `limit`, in lengths of its direction. Behind a
/// hole it begins anew, towards the same end.
pub fn is_blocked<R: Real>(
    flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    _path: &mut Path<R>,
    origin: Vec3<f32>,
    direction: Vec3<f32>,
    limit: f32,
) -> bool {
    let mut start = origin;
    let mut way = direction;
    let mut end = limit;
    for hole in 0..=MOST_HOLES {
        let ray: Ray<R> = Ray {
            origin: start,
            direction: way,
        }
        .converted();
        let mut hit = no_hit();
        hit.tile = NO_TILE;
        hit.t = constant(end);
        tracer.closest(probe_of(ray), &mut hit);
        if hit.id == NO_HIT {
            return false;
        }
        if hole == MOST_HOLES || !has_holes(flat, hit.id) {
            break;
        }
        let surface = surface_of(flat, ray, hit);
        if !is_hole(flat, ray, hit, &surface) {
            break;
        }
        start = leave_surface::<R>(surface.position, surface.facing, way, surface.reach);
        if limit == ENDLESS {
            continue;
        }
        way = (origin + direction * limit) - start;
        end = 1.0;
        // The end may be nearer than where it starts anew.
        if dot_product(way, direction) <= 0.0 {
            return false;
        }
    }
    true
}

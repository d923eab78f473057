//! Holes in shapes: where a texture's alpha is small, there is nothing.

use super::camera::Ray;
use super::hit::{Hit, NO_TILE, no_hit};
use super::integrator::Path;
use super::probe::probe_of;
use super::real::{Real, constant};
use super::tracer::Tracer;
use super::vector::Vec3;
use crate::flat::Flat;

/// What the path's ray meets first.
pub fn seen_hit<R: Real>(
    _flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    path: &mut Path<R>,
) -> Hit<R> {
    let mut hit = no_hit();
    hit.tile = NO_TILE;
    tracer.closest(probe_of(path.ray), &mut hit);
    hit
}

/// Whether a ray meets anything no later than at `limit`, in lengths of its direction.
pub fn is_blocked<R: Real>(
    _flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    _path: &mut Path<R>,
    origin: Vec3<f32>,
    direction: Vec3<f32>,
    limit: f32,
) -> bool {
    let ray: Ray<R> = Ray { origin, direction }.converted();
    tracer.any(probe_of(ray), constant(limit))
}

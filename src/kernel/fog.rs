//! Fog: a medium that is the same everywhere, and scatters light evenly.

use super::frame::cosine_direction;
use super::hit::{Hit, Surface};
use super::integrator::{Look, Path};
use super::real::Real;
use super::sources::{Arriving, cosine_at_surface};
use super::vector::{Vec3, dot_product};
use crate::flat::Flat;

/// The place in fog that scatters the path's light before it comes to the hit, if one does.
pub fn meets_fog<R: Real>(
    _flat: &Flat<R>,
    _path: &Path<R>,
    _hit: Hit<R>,
) -> Option<(Surface, Look)> {
    None
}

/// What fog leaves of light that comes to a place.
pub fn through_fog<R: Real>(_flat: &Flat<R>, color: Vec3<f32>, _arriving: &Arriving) -> Vec3<f32> {
    color
}

/// What of arriving light counts at a place: at a surface, the cosine.
pub fn cosine_towards(surface: &Surface, _look: &Look, arriving: &Arriving) -> f32 {
    cosine_at_surface(surface, arriving)
}

/// The same for a unit direction.
pub fn even_cosine(surface: &Surface, _look: &Look, direction: Vec3<f32>) -> f32 {
    dot_product(surface.normal, direction)
}

/// A direction, drawn as a place scatters light evenly.
pub fn even_direction(surface: &Surface, _look: &Look, pair: [f32; 2]) -> Vec3<f32> {
    cosine_direction(surface.normal, pair)
}

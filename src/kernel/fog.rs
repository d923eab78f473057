//! Fog: a medium that is the same everywhere, and scatters light evenly.
//!
//! Kajiya, Von Herzen, "Ray Tracing Volume Densities", SIGGRAPH 1984, of one density; and
//! Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th edition, 14.1, for how far a ray
//! comes.

use super::circle::circle_point;
use super::dimensions::{FOG_WAY, dimension_of};
use super::divide::{divide, square_root};
use super::exponential::{exponential, logarithm};
use super::frame::cosine_direction;
use super::hit::{Hit, Surface};
use super::indirect::even_chance;
use super::integrator::{Look, Path, leg_start, way_to_hit};
use super::numbers::number;
use super::real::Real;
use super::sources::{Arriving, ENDLESS, cosine_at_surface};
use super::vector::{Vec3, dot_product, unit_vector, vec3};
use crate::flat::Flat;
use crate::layout::NO_HIT;

/// A place in fog scatters to all sides alike, of all directions a part of 1 / (4 pi) each; a
/// white surface sends 1 / pi times the cosine. So this stands for the cosine.
pub const EVEN_COSINE: f32 = 0.25;

/// The place in fog that scatters the path's light before it comes to the hit, if one does.
///
/// The ways that are drawn are as long as light comes, so that of what is drawn nothing is
/// taken out besides: the transmittance cancels.
pub fn meets_fog<R: Real>(flat: &Flat<R>, path: &Path<R>, hit: Hit<R>) -> Option<(Surface, Look)> {
    let density = flat.fog.density;
    if density == 0.0 || path.is_inside {
        return None;
    }
    let drawn = number(path.numbers, dimension_of(path.leg, FOG_WAY));
    let way = divide(-logarithm(1.0 - drawn), density);
    let mut end = ENDLESS;
    if hit.id != NO_HIT {
        end = way_to_hit(path, hit);
    }
    if way >= end {
        return None;
    }
    let along = unit_vector(path.ray.direction.to_f32());
    let surface = Surface {
        position: leg_start(path) + along * way,
        normal: Vec3::default(),
        facing: Vec3::default(),
        reach: 0.0,
    };
    let mut look = Look {
        albedo: flat.fog.albedo.into(),
        energy: 1.0,
        is_fog: true,
        ..Look::default()
    };
    look.evenly = even_chance(path, &look);
    Some((surface, look))
}

/// What fog leaves of light that comes to a place: of what comes from infinitely far, nothing.
pub fn through_fog<R: Real>(flat: &Flat<R>, color: Vec3<f32>, arriving: &Arriving) -> Vec3<f32> {
    let density = flat.fog.density;
    if density == 0.0 {
        return color;
    }
    if arriving.is_far {
        return Vec3::default();
    }
    color * exponential(-(density * arriving.length))
}

/// What of arriving light counts at a place: at a surface, the cosine.
pub fn cosine_towards(surface: &Surface, look: &Look, arriving: &Arriving) -> f32 {
    if look.is_fog {
        return EVEN_COSINE;
    }
    cosine_at_surface(surface, arriving)
}

/// The same for a unit direction.
pub fn even_cosine(surface: &Surface, look: &Look, direction: Vec3<f32>) -> f32 {
    if look.is_fog {
        return EVEN_COSINE;
    }
    dot_product(surface.normal, direction)
}

/// A direction, drawn as a place scatters light evenly: in fog, any one alike.
///
/// Archimedes: parts of the sphere are as large as their heights.
pub fn even_direction(surface: &Surface, look: &Look, pair: [f32; 2]) -> Vec3<f32> {
    if !look.is_fog {
        return cosine_direction(surface.normal, pair);
    }
    let radius = square_root(4.0 * (pair[0] * (1.0 - pair[0])));
    let around = circle_point(pair[1]);
    vec3(radius * around[0], radius * around[1], 1.0 - 2.0 * pair[0])
}

//! Light that comes by way of other surfaces.

use super::dimensions::{ROULETTE, SCATTER, dimension_of};
use super::divide::divide;
use super::fog::{even_cosine, even_direction};
use super::hit::Surface;
use super::integrator::{Look, Path, send_on};
use super::numbers::{number, number_pair};
use super::real::Real;
use super::sources::{Arriving, searched_weight};
use super::vector::{divided, dot_product, largest_coordinate, taxicab_length};
use crate::flat::Flat;

/// The leg from which on a path may end by lot.
pub const FIRST_LOT: u32 = 2;

/// 1 / pi.
pub const BY_PI: f32 = std::f32::consts::FRAC_1_PI;

/// The density, by solid angle, of directions that are drawn by their cosine.
pub fn even_density(cosine: f32) -> f32 {
    cosine * BY_PI
}

/// How likely a path goes on evenly from a place: as bright as that is, beside the mirror.
pub fn even_chance<R: Real>(path: &Path<R>, look: &Look) -> f32 {
    let even = taxicab_length(look.albedo);
    if path.bounces == 0 || even == 0.0 {
        return 0.0;
    }
    let mirrored = taxicab_length(look.reflectance);
    if path.reflections == 0 || mirrored == 0.0 {
        return 1.0;
    }
    divide(even, even + mirrored)
}

/// The weight of light that was searched for, as for what is scattered evenly: the path may
/// find it too.
pub fn even_weight<R: Real>(flat: &Flat<R>, look: &Look, arriving: &Arriving, cosine: f32) -> f32 {
    searched_weight(flat, arriving.density, look.evenly * even_density(cosine))
}

/// Has the path go on from where light is scattered evenly. The cosine of the surface, and
/// what its directions are drawn by, cancel.
pub fn scatter_evenly<R: Real>(path: &mut Path<R>, surface: &Surface, look: &Look) -> bool {
    let pair = number_pair(path.numbers, dimension_of(path.leg, SCATTER));
    let direction = even_direction(surface, look, pair);
    if dot_product(surface.facing, direction) < 0.0 {
        return false;
    }
    path.bounces -= 1;
    path.density = look.evenly * even_density(even_cosine(surface, look, direction));
    send_on(path, surface, direction, divided(look.albedo, look.evenly))
}

/// Has a path that brings little end by lot; what goes on stands for those that do not. With
/// direct light alone, none ends so.
///
/// Arvo, Kirk, "Particle Transport and Image Synthesis", SIGGRAPH 1990.
pub fn survives<R: Real>(flat: &Flat<R>, path: &mut Path<R>) -> bool {
    if flat.sampling.bounces == 0 || path.leg < FIRST_LOT {
        return true;
    }
    let left = path.throughput;
    let largest = largest_coordinate(left);
    if largest >= 1.0 {
        return true;
    }
    if number(path.numbers, dimension_of(path.leg, ROULETTE)) >= largest {
        return false;
    }
    path.throughput = divided(left, largest);
    true
}

//! The sources of light, one after the other: what comes from each to a place.

use super::directional_sources::arriving_from_direction;
use super::divide::divide;
use super::hit::Surface;
use super::integrator::Path;
use super::lamps::{arriving_from_lamp, count_lamps};
use super::point_sources::arriving_from_point;
use super::real::Real;
use super::sky::{arriving_from_sky, count_skies};
use super::vector::{Vec3, dot_product};
use crate::flat::Flat;
use crate::layout::{ONLY_LIGHTS, ONLY_SURFACES};

/// What comes from a source to a place, if nothing is in between.
#[derive(Debug, Clone, Copy)]
pub struct Arriving {
    /// From the place towards the source.
    pub towards: Vec3<f32>,
    /// How long this is.
    pub length: f32,
    /// What a white surface looks like that faces it squarely, times `square`.
    pub color: Vec3<f32>,
    /// See `color`.
    pub square: f32,
    /// The point of the source, or the direction to it, from where it is infinitely far.
    pub goal: Vec3<f32>,
    /// Which of these.
    pub is_far: bool,
    /// Something before this part of the way keeps it off; 0 where nothing does.
    pub limit: f32,
    /// The density, by solid angle, with which this direction was drawn; 0 where only a
    /// source that is searched for is found.
    pub density: f32,
}

/// The farthest that a shadow ray may look.
pub const ENDLESS: f32 = f32::MAX;

/// Nothing comes.
pub fn nothing_arriving() -> Arriving {
    Arriving {
        towards: Vec3::default(),
        length: 1.0,
        color: Vec3::default(),
        square: 1.0,
        goal: Vec3::default(),
        is_far: false,
        limit: 0.0,
        density: 0.0,
    }
}

/// How many sources there are: the lights without size, the lamps, the sky.
pub fn count_sources<R: Real>(flat: &Flat<R>) -> u32 {
    flat.lights.len() as u32 + count_lamps(flat) + count_skies(flat)
}

/// What comes from a source.
pub fn arriving_from<R: Real>(
    flat: &Flat<R>,
    source: u32,
    path: &Path<R>,
    surface: &Surface,
) -> Arriving {
    if source < flat.surroundings.point_lights {
        return arriving_from_point(&flat.lights[source as usize], surface.position);
    }
    if source < flat.lights.len() as u32 {
        return arriving_from_direction(&flat.lights[source as usize]);
    }
    let lamp = source - flat.lights.len() as u32;
    if lamp < count_lamps(flat) {
        return arriving_from_lamp(flat, lamp, path, surface);
    }
    arriving_from_sky(flat, path, surface)
}

/// The cosine at which light comes to a surface.
pub fn cosine_at_surface(surface: &Surface, arriving: &Arriving) -> f32 {
    divide(
        dot_product(surface.normal, arriving.towards),
        arriving.length,
    )
}

/// The weight of light that was searched for with one density, where a path could have found
/// it with the other: Veach's balance heuristic.
pub fn searched_weight<R>(flat: &Flat<R>, density: f32, of_path: f32) -> f32 {
    if of_path == 0.0 || density == 0.0 || flat.sampling.strategy == ONLY_LIGHTS {
        return 1.0;
    }
    if flat.sampling.strategy == ONLY_SURFACES {
        return 0.0;
    }
    divide(density, density + of_path)
}

/// The weight of light that a path found with one density, where it was searched for with the
/// other.
pub fn found_weight<R>(flat: &Flat<R>, of_path: f32, density: f32) -> f32 {
    if of_path == 0.0 || flat.sampling.strategy == ONLY_SURFACES {
        return 1.0;
    }
    if flat.sampling.strategy == ONLY_LIGHTS {
        return 0.0;
    }
    divide(of_path, of_path + density)
}

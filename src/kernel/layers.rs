//! What is known of a ray's hit besides its colour.

use super::hit::Hit;
use super::integrator::{Path, way_to_hit};
use super::real::Real;
use super::trace::surface_of;
use crate::flat::Flat;
use crate::layout::{NO_HIT, Pixel};

/// The layers of a pixel, black.
pub fn layers_of<R: Real>(flat: &Flat<R>, path: &Path<R>, hit: Hit<R>) -> Pixel {
    if hit.id == NO_HIT {
        return Pixel {
            id: NO_HIT,
            tests: hit.tests,
            ..Pixel::default()
        };
    }
    let surface = surface_of(flat, path.ray, hit);
    Pixel {
        color: [0.0; 3],
        depth: way_to_hit(path, hit),
        normal: surface.normal.into(),
        id: hit.id,
        position: surface.position.into(),
        tests: hit.tests,
    }
}

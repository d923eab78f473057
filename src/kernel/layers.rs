//! What is known of a ray's hit besides its colour.

use super::camera::Ray;
use super::hit::Hit;
use super::real::Real;
use super::trace::surface_of;
use super::vector::vector_length;
use crate::flat::Flat;
use crate::layout::{NO_HIT, Pixel};

/// The layers of a pixel, black.
pub fn layers_of<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Pixel {
    if hit.id == NO_HIT {
        return Pixel {
            id: NO_HIT,
            tests: hit.tests,
            ..Pixel::default()
        };
    }
    let surface = surface_of(flat, ray, hit);
    Pixel {
        color: [0.0; 3],
        depth: (hit.t * vector_length(ray.direction)).to_f32(),
        normal: surface.normal.into(),
        id: hit.id,
        position: surface.position.into(),
        tests: hit.tests,
    }
}

//! An environment that shines from all sides.

use super::background::background_color;
use super::hit::Surface;
use super::integrator::Path;
use super::real::Real;
use super::sources::{Arriving, nothing_arriving};
use super::vector::Vec3;
use crate::flat::Flat;

/// How many skies there are: one or none.
pub fn count_skies<R>(_flat: &Flat<R>) -> u32 {
    0
}

/// What comes from the sky, by a direction drawn by its brightness.
pub fn arriving_from_sky<R>(_flat: &Flat<R>, _path: &Path<R>, _surface: &Surface) -> Arriving {
    nothing_arriving()
}

/// What a path sees that meets nothing.
pub fn seen_sky<R: Real>(flat: &Flat<R>, path: &Path<R>) -> Vec3<f32> {
    background_color(&flat.surroundings, path.ray.direction.to_f32())
}

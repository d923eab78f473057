//! Lamps that have a size.

use super::hit::{Hit, Surface};
use super::integrator::Path;
use super::sources::{Arriving, nothing_arriving};
use crate::flat::Flat;

/// How many lamps there are.
pub fn count_lamps<R>(_flat: &Flat<R>) -> u32 {
    0
}

/// What comes from a point drawn on a lamp.
pub fn arriving_from_lamp<R>(
    _flat: &Flat<R>,
    _lamp: u32,
    _path: &Path<R>,
    _surface: &Surface,
) -> Arriving {
    nothing_arriving()
}

/// How much of a lamp's light is due to a path that found it; 1 for what is no lamp.
pub fn weight_of_lamp<R>(
    _flat: &Flat<R>,
    _path: &Path<R>,
    _hit: Hit<R>,
    _surface: &Surface,
    _material: u32,
) -> f32 {
    1.0
}

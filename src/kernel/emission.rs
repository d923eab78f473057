//! Surfaces that shine by themselves.

use super::hit::{Hit, Surface};
use super::integrator::Path;
use super::lamps::weight_of_lamp;
use super::real::Real;
use super::vector::Vec3;
use crate::flat::Flat;

/// The radiance of a surface by itself; of a lamp, as much as is due to paths that find it.
pub fn emitted<R: Real>(
    flat: &Flat<R>,
    path: &Path<R>,
    hit: Hit<R>,
    surface: &Surface,
    material: u32,
) -> Vec3<f32> {
    let radiance = Vec3::from(flat.finishes[material as usize].emission);
    radiance * weight_of_lamp(flat, path, hit, surface, material)
}

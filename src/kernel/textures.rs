//! Textures: the albedo from place to place.

use super::camera::Ray;
use super::hit::{Hit, Surface};
use super::real::Real;
use super::vector::Vec3;
use crate::flat::Flat;

/// The albedo, times the texture of the place.
pub fn textured<R: Real>(
    _flat: &Flat<R>,
    _ray: Ray<R>,
    _hit: Hit<R>,
    _surface: &Surface,
    _material: u32,
    albedo: Vec3<f32>,
) -> Vec3<f32> {
    albedo
}

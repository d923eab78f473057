//! Mirrors, smooth and rough.

use super::hit::Surface;
use super::integrator::{Look, Path};
use super::real::Real;
use super::sources::Arriving;
use super::vector::Vec3;
use crate::flat::Flat;

/// Notes what a place mirrors.
pub fn mirror_look<R: Real>(
    _flat: &Flat<R>,
    _look: &mut Look,
    _path: &Path<R>,
    _surface: &Surface,
    _material: u32,
    _view: Vec3<f32>,
) {
}

/// What a rough mirror sends to the viewer of light that was searched for: `color` is what a
/// white surface would look like by it.
pub fn mirrored_light<R: Real>(
    _flat: &Flat<R>,
    _path: &Path<R>,
    _surface: &Surface,
    _look: &Look,
    _view: Vec3<f32>,
    _arriving: &Arriving,
    _color: Vec3<f32>,
) -> Vec3<f32> {
    Vec3::default()
}

/// Has the path go on as a mirror sends it, smooth or rough.
pub fn mirror_light<R: Real>(
    _path: &mut Path<R>,
    _surface: &Surface,
    _look: &Look,
    _view: Vec3<f32>,
) -> bool {
    false
}

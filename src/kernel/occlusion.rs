//! Ambient light that what is near keeps off.
//!
//! Zhukov, Iones, Kronin, "An Ambient Light Illumination Model", EGSR 1998.

use super::cutouts::is_blocked;
use super::dimensions::{AMBIENT, dimension_of};
use super::fog::even_direction;
use super::hit::Surface;
use super::integrator::{Look, Path};
use super::numbers::number_pair;
use super::offset::leave_surface;
use super::real::Real;
use super::tracer::Tracer;
use super::vector::Vec3;
use crate::flat::Flat;

/// The ambient light at a place, or none where the ray of the sample meets something near.
pub fn ambient_light<R: Real>(
    flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    path: &mut Path<R>,
    surface: &Surface,
    look: &Look,
) -> Vec3<f32> {
    let ambient = Vec3::from(flat.surroundings.ambient);
    if flat.sampling.occlusion == 0.0 {
        return ambient;
    }
    let pair = number_pair(path.numbers, dimension_of(path.leg, AMBIENT));
    let direction = even_direction(surface, look, pair);
    let origin = leave_surface::<R>(surface.position, surface.facing, direction, surface.reach);
    if is_blocked(
        flat,
        tracer,
        path,
        origin,
        direction,
        flat.sampling.occlusion,
    ) {
        return Vec3::default();
    }
    ambient
}

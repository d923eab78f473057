//! Shapes that keep light off others.

use super::cutouts::is_blocked;
use super::hit::Surface;
use super::integrator::Path;
use super::offset::leave_surface;
use super::real::Real;
use super::sources::Arriving;
use super::tracer::Tracer;
use super::vector::dot_product;
use crate::flat::Flat;

/// Whether something lies between a place and the source that light comes from.
pub fn is_shadowed<R: Real>(
    flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    path: &mut Path<R>,
    surface: &Surface,
    arriving: &Arriving,
) -> bool {
    if arriving.limit == 0.0 {
        return false;
    }
    let towards = arriving.towards;
    // What a smooth normal sees, but for the surface itself: no path goes there either.
    if dot_product(surface.facing, towards) < 0.0 {
        return true;
    }
    let origin = leave_surface::<R>(surface.position, surface.facing, towards, surface.reach);
    let direction = if arriving.is_far {
        arriving.goal
    } else {
        arriving.goal - origin
    };
    is_blocked(flat, tracer, path, origin, direction, arriving.limit)
}

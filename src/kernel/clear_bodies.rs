//! Clear bodies: light goes through them, bent, and is thrown back at their surface.

use super::hit::{Hit, Surface};
use super::integrator::Path;
use super::real::Real;
use crate::flat::Flat;

/// Whether bodies of the material are clear.
pub fn is_clear<R: Real>(_flat: &Flat<R>, _material: u32) -> bool {
    false
}

/// Takes out of the path what the body around its ray absorbs on its way to the hit.
pub fn pass_medium<R: Real>(_path: &mut Path<R>, _hit: Hit<R>) {}

/// Has the path go on from a clear surface: through it, or thrown back.
pub fn pass_clear<R: Real>(
    _flat: &Flat<R>,
    _path: &mut Path<R>,
    _hit: Hit<R>,
    _surface: &Surface,
    _material: u32,
) -> bool {
    false
}

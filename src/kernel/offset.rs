//! Where a ray starts that leaves a surface: far enough not to meet it again.
//!
//! Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th edition, 6.8.6: by the bound of
//! the error, not by a fixed length.

use super::real::{Real, constant};
use super::vector::{Vec3, dot_product};
use crate::tier::Formulas;

/// By how much the start is moved along the normal, in parts of the shape's reach: the point
/// is off by at most 10 roundings of it and a test from there by 30, see `docs/numerics.md`.
pub const OFFSET: f32 = 48.0 / 16_777_216.0;

/// The length by which a textbook moves it, whatever the scene's scale.
pub const FIXED_OFFSET: f32 = 1e-3;

/// The start of a ray in `direction` from a point of a surface with this unit normal, of a
/// shape that reaches so far from the camera.
pub fn leave_surface<R: Real>(
    point: Vec3<R>,
    normal: Vec3<R>,
    direction: Vec3<R>,
    reach: R,
) -> Vec3<R> {
    let away = if dot_product(normal, direction) < R::ZERO {
        -normal
    } else {
        normal
    };
    if R::FORMULAS == Formulas::Textbook {
        return point + away * constant(FIXED_OFFSET);
    }
    point + away * (reach * constant(OFFSET))
}

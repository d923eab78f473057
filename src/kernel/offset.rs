//! Where a ray starts that leaves a surface: far enough not to meet it again.
//!
//! Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th edition, 6.8.6: by the bound of
//! the error, not by a fixed length.

use super::real::Real;
use super::vector::{Vec3, dot_product};
use crate::tier::Formulas;

/// By how much the start is moved along the normal, in parts of the surface's reach: the
/// point is off by at most 12 roundings of it and a test from there by 30, see
/// `docs/numerics.md`.
pub const OFFSET: f32 = 48.0 / 16_777_216.0;

/// The length by which a textbook moves it, whatever the scene's scale.
pub const FIXED_OFFSET: f32 = 1e-3;

/// The start of a ray in `direction` from a surface with this unit normal, of a shape that
/// reaches so far. In f32 in every width, as rays of a list are.
pub fn leave_surface<R: Real>(
    position: Vec3<f32>,
    facing: Vec3<f32>,
    direction: Vec3<f32>,
    reach: f32,
) -> Vec3<f32> {
    let away = if dot_product(facing, direction) < 0.0 {
        -facing
    } else {
        facing
    };
    if R::FORMULAS == Formulas::Textbook {
        return position + away * FIXED_OFFSET;
    }
    position + away * (reach * OFFSET)
}

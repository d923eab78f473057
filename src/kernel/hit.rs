//! The closest hit so far, and the surface that is found there.

use super::real::Real;
use super::vector::Vec3;
use crate::layout::NO_HIT;

/// In place of a hit's tests: the ray was given up.
pub const GIVEN_UP: u32 = u32::MAX;

/// In place of a ray's tile: it is none of the rays that go through one of a tile's pixels.
pub const NO_TILE: u32 = u32::MAX;

/// The closest hit so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit<R> {
    /// The ray's parameter there, or `MISS`.
    pub t: R,
    /// The primitive, or [`NO_HIT`].
    pub id: u32,
    /// Its row in its kind's table.
    pub row: u32,
    /// The ray's parameter lies between this and `high`, where formulas bound their error.
    pub low: R,
    /// See `low`; `MISS` where nothing is hit for certain.
    pub high: R,
    /// The least parameter at which the ray may meet another primitive.
    pub rival: R,
    /// Shapes tested so far.
    pub tests: u32,
    /// The tile of the screen that the ray goes through.
    pub tile: u32,
    /// When shapes are looked for, see [`super::motion::shutter_time`].
    pub time: f32,
    /// Volumes tested so far.
    pub bound_tests: u32,
    /// Those of them that the ray met.
    pub bound_hits: u32,
}

/// Where a ray meets a primitive first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting<R> {
    /// The ray's parameter there, or `MISS`.
    pub t: R,
    /// No sooner than here; `MISS` where it certainly does not.
    pub low: R,
    /// No later than here; `MISS` where it may not meet it at all.
    pub high: R,
}

/// What shading needs to know of a hit, and a ray that leaves from there.
#[derive(Debug, Clone, Copy, Default)]
pub struct Surface {
    /// Camera-relative.
    pub position: Vec3<f32>,
    /// Unit length, facing the viewer.
    pub normal: Vec3<f32>,
    /// The same of the shape itself: another one where normals are smooth.
    pub facing: Vec3<f32>,
    /// How far the shape reaches from the camera, and the ray's origin, by their taxicab
    /// lengths: what roundings are parts of.
    pub reach: f32,
}

/// Nothing hit, nothing tested.
pub fn no_hit<R: Real>() -> Hit<R> {
    Hit {
        t: R::MISS,
        id: NO_HIT,
        row: 0,
        low: R::MISS,
        high: R::MISS,
        rival: R::MISS,
        tests: 0,
        tile: 0,
        time: 0.0,
        bound_tests: 0,
        bound_hits: 0,
    }
}

/// Counts a shape that was tested.
pub fn count_test<R: Real>(hit: &mut Hit<R>) {
    hit.tests += 1;
}

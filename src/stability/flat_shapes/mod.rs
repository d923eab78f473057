//! Planes and disks: edges-on, rims, thresholds.

mod level;
mod placed;
mod rim;

use super::case::Family;
use super::shapes::{flat_of, scene_of};
use crate::flat::Flat;
use crate::scene::Geometry;

/// Planes and disks.
pub const FAMILY: Family = Family {
    name: "flat",
    about: "Planes and disks: edges-on, rims, thresholds.",
    cases: &[&[
        level::IN_PLANE,
        level::START_ON_PLANE,
        level::SLOPE_1E_8,
        level::SLOPE_OBLIQUE,
        level::EDGE_ON,
        level::BEYOND_F32,
        placed::PLANE_1E6,
        placed::DISK_1E6,
        placed::BEHIND,
        placed::COPLANAR,
        placed::EQUAL,
        placed::NORMAL_LENGTH,
        placed::DIRECTION_LENGTH,
        rim::EXACT,
        rim::ULP,
        rim::AIMED,
        rim::TINY,
        rim::SMALLEST,
        rim::LARGEST,
    ]],
};

/// Shapes, rounded, that stand where the camera is the origin.
fn rounded(shapes: impl IntoIterator<Item = Geometry>) -> Flat<f64> {
    flat_of(&scene_of(shapes))
}

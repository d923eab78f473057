//! Spheres: far, near, large, small, touched.

mod far;
mod near;
mod scale;
mod start;
mod touched;

use glam::DVec3;

use super::case::Family;
use super::shapes::{flat_of, scene_of, sphere};
use crate::flat::Flat;

/// Spheres.
pub const FAMILY: Family = Family {
    name: "sphere",
    about: "Spheres: far, near, large, small, touched.",
    cases: &[&[
        far::AT_1E3,
        far::AT_1E4,
        far::AT_1E5,
        far::AT_1E5_SEEN,
        far::AT_1E6,
        far::AT_1E7,
        far::SMALL,
        far::AWAY_FROM_CAMERA,
        near::EYE_1_ABOVE,
        near::HORIZON,
        near::GROUND_SEEN,
        near::GROUND_WALK,
        near::START_JUST_ABOVE,
        near::SEEN_FROM_FAR,
        near::LEAVING,
        touched::TANGENT,
        touched::TANGENT_ULP,
        touched::GROWING,
        touched::SHELLS,
        touched::GAP_BETWEEN_SHELLS,
        touched::EQUAL,
        touched::KISSING,
        start::OUTWARD,
        start::INWARD,
        start::CENTER_OF_IT,
        start::ABREAST,
        start::BEHIND,
        scale::DIRECTION_1E10,
        scale::DIRECTION_POWERS,
        scale::DIRECTION_LONG,
        scale::DIRECTION_SHORT,
        scale::SMALLEST,
        scale::LARGEST,
        scale::ORIGIN_1E20,
        scale::CENTER_1E20,
        scale::RADIUS_REFUSED,
    ]],
};

/// Spheres, rounded, that stand where the camera is the origin.
fn spheres(of: impl IntoIterator<Item = (DVec3, f64)>) -> Flat<f64> {
    let shapes = of
        .into_iter()
        .map(|(center, radius)| sphere(center, radius));
    flat_of(&scene_of(shapes))
}

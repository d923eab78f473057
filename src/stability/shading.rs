//! Rays that leave surfaces, and light.

use super::case::Family;

/// Rays that leave surfaces, and light.
pub const FAMILY: Family = Family {
    name: "shading",
    about: "Rays that leave surfaces, and light.",
    cases: &[],
};

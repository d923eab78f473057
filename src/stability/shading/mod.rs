//! Rays that leave surfaces, and light.

mod leaving;
mod light;
mod mirrors;
mod refraction;

use super::case::Family;

/// Rays that leave surfaces, and light.
pub const FAMILY: Family = Family {
    name: "shading",
    about: "Rays that leave surfaces, and light. Where a ray leaves a surface, it starts a bound \
            of the error away from it.",
    cases: &[
        leaving::CASES,
        light::CASES,
        mirrors::CASES,
        refraction::CASES,
    ],
};

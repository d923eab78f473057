//! Bounding volumes: rays in their faces and corners, odd trees.

mod corners;
mod faces;
mod trees;
mod volumes;

use super::case::Family;

/// Bounding volumes: rays in their faces and corners, odd trees.
pub const FAMILY: Family = Family {
    name: "bounds",
    about: "Bounding volumes: rays in their faces and corners, odd trees.",
    cases: &[faces::CASES, corners::CASES, trees::CASES, volumes::CASES],
};

//! Bounding volumes: rays in their faces and corners, odd trees.

use super::case::Family;

/// Bounding volumes: rays in their faces and corners, odd trees.
pub const FAMILY: Family = Family {
    name: "bounds",
    about: "Bounding volumes: rays in their faces and corners, odd trees.",
    cases: &[],
};

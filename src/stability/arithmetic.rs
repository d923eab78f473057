//! Sums, products, quotients and roots: what all else rests on.

use super::case::Family;

/// Sums, products, quotients and roots: what all else rests on.
pub const FAMILY: Family = Family {
    name: "arithmetic",
    about: "Sums, products, quotients and roots: what all else rests on.",
    cases: &[],
};

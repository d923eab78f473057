//! Planes and disks: seen along, from near, their rims.

use super::case::Family;

/// Planes and disks: seen along, from near, their rims.
pub const FAMILY: Family = Family {
    name: "flat",
    about: "Planes and disks: seen along, from near, their rims.",
    cases: &[],
};

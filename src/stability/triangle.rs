//! Triangles: shared edges and vertices, slivers, those without area.

use super::case::Family;

/// Triangles: shared edges and vertices, slivers, those without area.
pub const FAMILY: Family = Family {
    name: "triangle",
    about: "Triangles: shared edges and vertices, slivers, those without area.",
    cases: &[],
};

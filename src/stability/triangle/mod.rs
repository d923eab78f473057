//! Triangles: shared edges and vertices, slivers, those without area.

mod exact;
mod leaks;
mod orders;
mod sizes;
mod slivers;

use super::case::Family;

/// Triangles: shared edges and vertices, slivers, those without area.
pub const FAMILY: Family = Family {
    name: "triangle",
    about: "Triangles: shared edges and vertices, slivers, those without area.",
    cases: &[
        leaks::CASES,
        slivers::CASES,
        sizes::CASES,
        exact::CASES,
        orders::CASES,
    ],
};

/// The roundings of a point on a triangle of fair proportions, in u B. Sheared corners are
/// each off by 5.2 u of their distance, and a point between them is off by no more; t takes
/// 5 u t |d|, of weights, dot product and quotients; the edge functions' products move it by 3
/// u L^3 / area, 7 u L of an equilateral triangle of edge L.
const ON_PLANE: f64 = 16.0;

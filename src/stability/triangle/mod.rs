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

/// The roundings of a point on a triangle, whatever its shape, in u B. Sheared corners are each
/// off by 5.2 u of their distance, and a point between them is off by no more. The weights are
/// those of a point 6 u L away across the ray, where L is the longest edge, sheared; the depth
/// they give takes 3 u L, and t 2 u t |d|. L is at most the corners' distance here.
const ON_PLANE: f64 = 16.0;

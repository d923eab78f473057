//! The cube and the tetrahedron: flat faces, no normals.

use glam::{DVec3, dvec3};

use super::super::Mesh;
use super::nearest;
use super::subdivide::subdivide;

/// The unit cube around the origin, 12 n^2 triangles, n >= 1.
pub(super) fn cube(detail: u32) -> Mesh {
    let n = nearest(detail, 1, |n| 12 * n * n);
    // Corner c has bit 0, 1, 2 set where x, y, z is positive.
    let corners: [DVec3; 8] = std::array::from_fn(|c| {
        let side = |bit: usize| if c >> bit & 1 == 1 { 0.5 } else { -0.5 };
        dvec3(side(0), side(1), side(2))
    });
    let faces = [
        [0, 4, 6, 2], // x = -1/2
        [1, 3, 7, 5], // x = +1/2
        [0, 1, 5, 4], // y = -1/2
        [2, 6, 7, 3], // y = +1/2
        [0, 2, 3, 1], // z = -1/2
        [4, 5, 7, 6], // z = +1/2
    ];
    let halves: Vec<[u32; 3]> = faces
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .collect();
    subdivide(&corners, &halves, n)
}

/// The regular tetrahedron around the origin, one corner at (0, 1, 0), all at
/// distance 1; 4 n^2 triangles, n >= 1.
pub(super) fn tetrahedron(detail: u32) -> Mesh {
    let n = nearest(detail, 1, |n| 4 * n * n);
    let [third, far] = [1.0 / 3.0, (8.0_f64 / 9.0).sqrt()];
    let [near, side] = [(2.0_f64 / 9.0).sqrt(), (2.0_f64 / 3.0).sqrt()];
    let corners = [
        dvec3(0.0, 1.0, 0.0),
        dvec3(far, -third, 0.0),
        dvec3(-near, -third, side),
        dvec3(-near, -third, -side),
    ];
    let faces = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]];
    subdivide(&corners, &faces, n)
}

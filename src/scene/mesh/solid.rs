//! The cube and the tetrahedron: flat faces, no normals.

use glam::{DVec3, dvec3};
use rayon::prelude::*;

use super::super::Mesh;
use super::subdivide::subdivide;
use super::{grid, nearest};

/// The directions of u and v on the cube's faces, in their order: v upward on those that
/// stand, and away from a viewer who looks along -z on those that lie.
const FACE_AXES: [[DVec3; 2]; 6] = [
    [DVec3::Z, DVec3::Y],
    [DVec3::NEG_Z, DVec3::Y],
    [DVec3::X, DVec3::Z],
    [DVec3::X, DVec3::NEG_Z],
    [DVec3::NEG_X, DVec3::Y],
    [DVec3::X, DVec3::Y],
];

/// The unit cube around the origin, 12 n^2 triangles, n >= 1. Texture coordinates go from 0
/// to 1 on each face.
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
    let mesh = subdivide(&corners, &halves, n);
    let parts = f64::from(n);
    let (columns, to_a_face) = (n + 1, (n + 1) * (n + 1));
    // Of the lattice over each face; a face's triangles stand together.
    let triangle_uvs = mesh.triangles.par_iter().enumerate().map(|(i, triangle)| {
        let face = i / (2 * n as usize * n as usize);
        triangle.map(|vertex| {
            let place = mesh.positions[vertex as usize];
            // Rounding is far below half a step.
            let step = |axis: DVec3| ((place.dot(axis) + 0.5) * parts).round() as u32;
            let [column, row] = FACE_AXES[face].map(step);
            face as u32 * to_a_face + row * columns + column
        })
    });
    Mesh {
        uvs: grid::uvs(n, n, |i, j| [j / parts, i / parts]).repeat(6),
        triangle_uvs: triangle_uvs.collect(),
        ..mesh
    }
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

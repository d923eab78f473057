//! The geodesic sphere.

use glam::{DVec3, dvec3};
use rayon::prelude::*;

use super::super::Mesh;
use super::subdivide::subdivide;
use super::{nearest, smooth};

/// The faces of the icosahedron over [`corners`].
const FACES: [[u32; 3]; 20] = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
];

/// A sphere of radius 1 around the origin: the icosahedron's edges split in
/// n >= 1 parts, the vertices pushed outward on the sphere; 20 n^2 triangles,
/// 10 n^2 + 2 vertices. A vertex is its own normal.
pub(super) fn icosphere(detail: u32) -> Mesh {
    let n = nearest(detail, 1, |n| 20 * n * n);
    let Mesh {
        mut positions,
        triangles,
        ..
    } = subdivide(&corners(), &FACES, n);
    positions.par_iter_mut().for_each(|p| *p = p.normalize());
    let normals = positions.clone();
    smooth(positions, normals, triangles)
}

/// Three golden rectangles, one in each coordinate plane.
fn corners() -> [DVec3; 12] {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    [
        dvec3(-1.0, golden, 0.0),
        dvec3(1.0, golden, 0.0),
        dvec3(-1.0, -golden, 0.0),
        dvec3(1.0, -golden, 0.0),
        dvec3(0.0, -1.0, golden),
        dvec3(0.0, 1.0, golden),
        dvec3(0.0, -1.0, -golden),
        dvec3(0.0, 1.0, -golden),
        dvec3(golden, 0.0, -1.0),
        dvec3(golden, 0.0, 1.0),
        dvec3(-golden, 0.0, -1.0),
        dvec3(-golden, 0.0, 1.0),
    ]
}

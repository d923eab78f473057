//! Subdivision of a polyhedron with triangular faces.

use glam::DVec3;
use rayon::prelude::*;

use super::super::Mesh;

/// Splits every edge in `n` >= 1 equal parts and every face in n^2 triangles
/// (class I of the geodesic polyhedra). Vertices on edges are computed once and
/// shared; the faces keep their winding. No normals.
///
/// `faces` are indices into `corners`.
pub(super) fn subdivide(corners: &[DVec3], faces: &[[u32; 3]], n: u32) -> Mesh {
    let lattice = Lattice::new(corners.len(), faces, n);
    let corner = |c: u32| corners[c as usize];
    let scale = f64::from(n);

    let mut positions = corners.to_vec();
    positions.par_extend(lattice.edges.par_iter().flat_map_iter(|&[a, b]| {
        (1..n).map(move |s| (corner(a) * f64::from(n - s) + corner(b) * f64::from(s)) / scale)
    }));
    positions.par_extend(faces.par_iter().flat_map_iter(|&[a, b, c]| {
        (2..n).flat_map(move |row| {
            (1..row).map(move |col| {
                let [ka, kb, kc] = [n - row, row - col, col].map(f64::from);
                (corner(a) * ka + corner(b) * kb + corner(c) * kc) / scale
            })
        })
    }));

    let lattice = &lattice;
    let triangles = (0..faces.len() as u32)
        .into_par_iter()
        .flat_map_iter(|face| (0..n).flat_map(move |row| lattice.row_triangles(face, faces, row)))
        .collect();
    Mesh {
        positions,
        triangles,
        ..Mesh::default()
    }
}

/// Where the vertices stand: first the corners, then n - 1 on each edge, then
/// those inside each face, row by row. Row r of a face has r + 1 points; row 0
/// is the face's first corner, row n its opposite edge.
struct Lattice {
    n: u32,
    corners: u32,
    /// The ends of each edge, the lower first.
    edges: Vec<[u32; 2]>,
}

impl Lattice {
    fn new(corners: usize, faces: &[[u32; 3]], n: u32) -> Self {
        let mut edges: Vec<[u32; 2]> = faces
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        Self {
            n,
            corners: corners as u32,
            edges,
        }
    }

    /// The vertex on the edge from `a` to `b`, `step` of n parts away from `a`.
    fn on_edge(&self, a: u32, b: u32, step: u32) -> u32 {
        if step == 0 {
            return a;
        }
        if step == self.n {
            return b;
        }
        let (ends, step) = if a < b {
            ([a, b], step)
        } else {
            ([b, a], self.n - step)
        };
        let edge = self.edges.partition_point(|&e| e < ends) as u32;
        self.corners + edge * (self.n - 1) + step - 1
    }

    /// The vertex of a face at (row, col), 0 <= col <= row <= n.
    fn in_face(&self, face: u32, [a, b, c]: [u32; 3], row: u32, col: u32) -> u32 {
        if col == 0 {
            return self.on_edge(a, b, row);
        }
        if col == row {
            return self.on_edge(a, c, row);
        }
        if row == self.n {
            return self.on_edge(b, c, col);
        }
        let inside_a_face = (self.n - 1) * (self.n - 2) / 2;
        let before = self.corners + self.edges.len() as u32 * (self.n - 1);
        before + face * inside_a_face + (row - 1) * (row - 2) / 2 + col - 1
    }

    /// The 2 row + 1 triangles between rows `row` and `row` + 1 of a face.
    fn row_triangles(
        &self,
        face: u32,
        faces: &[[u32; 3]],
        row: u32,
    ) -> impl Iterator<Item = [u32; 3]> {
        let corners = faces[face as usize];
        let at = move |row, col| self.in_face(face, corners, row, col);
        (0..=row).flat_map(move |col| {
            let tip_first = [at(row, col), at(row + 1, col), at(row + 1, col + 1)];
            let tip_last =
                (col < row).then(|| [at(row, col), at(row + 1, col + 1), at(row, col + 1)]);
            std::iter::once(tip_first).chain(tip_last)
        })
    }
}

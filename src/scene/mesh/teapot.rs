//! Newell's teapot, welded.

use glam::{DVec3, dvec3};
use rayon::prelude::*;

use super::super::Mesh;
use super::teapot_points::{BODY, HANDLE, LID, Row, SPOUT};
use super::{grid, nearest, smooth};

/// With one part to a patch edge, handle and spout would fold flat.
const LEAST_PARTS: u32 = 2;

/// Signs of Newell's x and y in the four quarters, in the order in which they
/// meet, clockwise seen from above.
const QUARTERS: &[[f64; 2]] = &[[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
/// The same for the two halves of a tube.
const HALVES: &[[f64; 2]] = &[[1.0, 1.0], [1.0, -1.0]];

/// A chain of patches and its mirror images: a grid of vertices, closed along
/// its rows.
struct Piece {
    /// Control points, see [`teapot_points`](super::teapot_points).
    chain: &'static [Row],
    /// One reflection for each image. Neighbouring images run in opposite
    /// directions, so that their common edge has the same bits in both.
    images: &'static [[f64; 2]],
    /// The end of the chain, if any, where the row shrinks to one point, and
    /// the normal there, where the derivatives vanish.
    pole: Option<(End, DVec3)>,
}

#[derive(Clone, Copy, PartialEq)]
enum End {
    First,
    Last,
}

const PIECES: [Piece; 4] = [
    Piece {
        chain: &BODY,
        images: QUARTERS,
        pole: Some((End::Last, DVec3::NEG_Y)),
    },
    Piece {
        chain: &LID,
        images: QUARTERS,
        pole: Some((End::First, DVec3::Y)),
    },
    Piece {
        chain: &HANDLE,
        images: HALVES,
        pole: None,
    },
    Piece {
        chain: &SPOUT,
        images: HALVES,
        pole: None,
    },
];

/// The 32 patches with n >= 2 parts to each edge, less the triangles that vanish
/// at the top of the lid and the middle of the bottom: 64 n^2 - 8 n triangles.
///
/// y up, the spout along +x, the middle of the bottom at the origin. Vertices
/// are shared wherever patches meet; what is open is open in Newell's data: the
/// gap between rim and lid, and the ends of handle and spout. Normals are the
/// surface's; below n = 6 the facets at the spout's lip are too coarse for them
/// and some face away.
///
/// Texture coordinates are the patches' parameters, one unit to a patch, running on from
/// patch to patch: u against the columns, v against the rows, so that body and lid have v
/// upward.
pub(super) fn teapot(detail: u32) -> Mesh {
    let n = nearest(detail, LEAST_PARTS, |n| 64 * n * n - 8 * n);
    let weights: Vec<Weights> = (0..=n).map(|l| Weights::new(l, n)).collect();
    let [mut positions, mut normals] = [Vec::new(), Vec::new()];
    let mut triangles = Vec::new();
    let (mut uvs, mut triangle_uvs) = (Vec::new(), Vec::new());
    for piece in &PIECES {
        let (rows, columns) = (piece.rows(n), piece.columns(n));
        let index = |i, j| piece.index(n, i, j);
        let base = positions.len() as u32;
        let moved = |triangle: [u32; 3], base: u32| triangle.map(|i| base + i);
        let grid = grid::triangles(rows, columns, index);
        triangles.extend(grid.into_iter().map(|t| moved(t, base)));
        let first = uvs.len() as u32;
        let grid = grid::uv_triangles(rows, columns, index);
        triangle_uvs.extend(grid.into_iter().map(|t| moved(t, first)));
        uvs.extend(grid::uvs(rows, columns, |i, j| {
            [f64::from(columns) - j, f64::from(rows) - i].map(|x| x / f64::from(n))
        }));
        let (p, q): (Vec<DVec3>, Vec<DVec3>) = (0..piece.vertices(n))
            .into_par_iter()
            .map(|v| piece.vertex(n, &weights, v))
            .unzip();
        positions.extend(p);
        normals.extend(q);
    }
    Mesh {
        uvs,
        triangle_uvs,
        ..smooth(positions, normals, triangles)
    }
}

impl Piece {
    /// Steps along the chain.
    fn rows(&self, n: u32) -> u32 {
        self.chain.len() as u32 / 3 * n
    }

    /// Steps around a row.
    fn columns(&self, n: u32) -> u32 {
        self.images.len() as u32 * n
    }

    fn vertices(&self, n: u32) -> u32 {
        match self.pole {
            Some(_) => self.rows(n) * self.columns(n) + 1,
            None => (self.rows(n) + 1) * self.columns(n),
        }
    }

    /// The vertex at row i and column j, counted within this piece: row after
    /// row, a pole counting as one.
    fn index(&self, n: u32, i: u32, j: u32) -> u32 {
        let columns = self.columns(n);
        let j = j % columns;
        match self.pole {
            Some((End::First, _)) if i == 0 => 0,
            Some((End::First, _)) => (i - 1) * columns + j + 1,
            Some((End::Last, _)) if i == self.rows(n) => i * columns,
            _ => i * columns + j,
        }
    }

    /// Position and normal of the vertex of that index.
    fn vertex(&self, n: u32, weights: &[Weights], index: u32) -> (DVec3, DVec3) {
        let columns = self.columns(n);
        let [i, j] = match self.pole {
            Some((End::First, _)) if index == 0 => [0, 0],
            Some((End::First, _)) => [(index - 1) / columns + 1, (index - 1) % columns],
            _ => [index / columns, index % columns],
        };
        let patch = (i / n).min(self.chain.len() as u32 / 3 - 1);
        let image = (j / n) as usize;
        let along = if image.is_multiple_of(2) {
            j % n
        } else {
            n - j % n
        };
        let rows = &self.chain[3 * patch as usize..][..4];
        let (position, normal) = evaluate(
            rows,
            &weights[along as usize],
            &weights[(i - patch * n) as usize],
        );

        let turned = |v: DVec3| {
            let [x, y] = self.images[image];
            // Newell's z is up; + 0 turns a mirrored zero's sign back.
            dvec3(v.x * x, v.z, -v.y * y) + DVec3::ZERO
        };
        match self.pole {
            Some((End::First, pole)) if i == 0 => (turned(position), pole),
            Some((End::Last, pole)) if i == self.rows(n) => (turned(position), pole),
            _ => (turned(position), turned(normal.normalize())),
        }
    }
}

/// A patch's point and its normal, not of unit length: the derivative along a
/// row (weights `u`) cross the one from row to row (weights `v`).
fn evaluate(rows: &[Row], u: &Weights, v: &Weights) -> (DVec3, DVec3) {
    let mut point = DVec3::ZERO;
    let [mut along_u, mut along_v] = [DVec3::ZERO; 2];
    for (row, (v_value, v_slope)) in rows.iter().zip(v.value.iter().zip(v.slope)) {
        for (&control, (u_value, u_slope)) in row.iter().zip(u.value.iter().zip(u.slope)) {
            let control = DVec3::from_array(control);
            point += control * (u_value * v_value);
            along_u += control * (u_slope * v_value);
            along_v += control * (u_value * v_slope);
        }
    }
    (point, along_u.cross(along_v))
}

/// The cubic Bernstein polynomials and their derivatives at one parameter.
struct Weights {
    value: [f64; 4],
    slope: [f64; 4],
}

impl Weights {
    /// At `part` / `parts`. At both ends a single weight is 1 and the others are
    /// 0, so a patch's edge depends on that edge's control points alone.
    fn new(part: u32, parts: u32) -> Self {
        let t = f64::from(part) / f64::from(parts);
        let s = f64::from(parts - part) / f64::from(parts);
        Self {
            value: [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t],
            slope: [
                -3.0 * s * s,
                3.0 * s * (s - 2.0 * t),
                3.0 * t * (2.0 * s - t),
                3.0 * t * t,
            ],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::check::{doubles, euler_characteristic, fault, least_cosine, open_edges};
    use super::*;

    fn of(n: u32) -> Mesh {
        teapot(64 * n * n - 8 * n)
    }

    fn bounds(mesh: &Mesh) -> (DVec3, DVec3) {
        let low = mesh.positions.iter().fold(DVec3::MAX, |a, &p| a.min(p));
        let high = mesh.positions.iter().fold(DVec3::MIN, |a, &p| a.max(p));
        (low, high)
    }

    #[test]
    fn chains_are_whole_patches() {
        for piece in &PIECES {
            assert_eq!(piece.chain.len() % 3, 1);
        }
        let patches = |p: &Piece| p.chain.len() / 3 * p.images.len();
        assert_eq!(PIECES.iter().map(patches).sum::<usize>(), 32);
    }

    #[test]
    fn only_newells_openings_are_open() {
        for n in 2..12 {
            let mesh = of(n);
            assert_eq!(fault(&mesh), None, "n = {n}");
            // The spout's lip turns through a right angle and more within a third
            // of a patch; coarser facets cannot follow its normals.
            assert_eq!(least_cosine(&mesh) > 0.0, n >= 6, "n = {n}");
            // In Newell's data the handle touches the body in one point; it is
            // a vertex of each, for their normals differ.
            let touch = doubles(&mesh);
            let place = touch.first().map(|t| mesh.positions[t[0] as usize]);
            assert_eq!((touch.len(), place), (1, Some(dvec3(-2.0, 0.9, 0.0))));
            // Rim and lid have 4 n edges, each end of handle and spout 2 n.
            assert_eq!(open_edges(&mesh), 16 * n as usize, "n = {n}");
            // A bowl, a lid (disks, 1 each) and two tubes (0 each).
            assert_eq!(euler_characteristic(&mesh), 2, "n = {n}");
        }
        // Control: a corner torn off opens edges inside.
        let mut torn = of(3);
        let belly = |t: &[u32; 3]| torn.positions[t[1] as usize].z > 1.5;
        let i = torn.triangles.iter().position(belly).unwrap();
        let mut corner = torn.positions[torn.triangles[i][1] as usize];
        corner.z = corner.z.next_up();
        torn.triangles[i][1] = torn.positions.len() as u32;
        torn.positions.push(corner);
        assert_eq!(open_edges(&torn), 16 * 3 + 4);
    }

    #[test]
    fn it_has_its_known_size() {
        let (low, high) = bounds(&of(10));
        assert_eq!([low.x, low.y, high.y], [-3.0, 0.0, 3.15]);
        // The bulge at half height: 2 at the patch corners on z.
        assert_eq!([low.z, high.z], [-2.0, 2.0]);
        // The spout's lip: the cubic of 3.3, 3.525, 3.45, 3.2 at 4/10.
        assert!(
            (high.x - 3.434).abs() < 8.0 * f64::EPSILON * 3.434,
            "{high}"
        );
    }

    #[test]
    fn it_mirrors_itself_to_the_bit() {
        let mesh = of(5);
        let key = |p: DVec3| (p + DVec3::ZERO).to_array().map(f64::to_bits);
        let all: std::collections::HashSet<_> = mesh.positions.iter().map(|&p| key(p)).collect();
        for &p in &mesh.positions {
            assert!(all.contains(&key(dvec3(p.x, p.y, -p.z))), "{p}");
        }
        let aside = mesh.positions.iter().find(|p| p.z > 1.0).copied();
        let skewed = aside.map(|p| key(dvec3(p.x, p.y, -p.z.next_up())));
        assert!(skewed.is_some_and(|k| !all.contains(&k)));
    }

    #[test]
    fn normals_agree_on_both_sides_of_a_patch_edge() {
        let ends = [Weights::new(0, 1), Weights::new(1, 1)];
        let across = |chain: &[Row], k: usize| {
            let u = Weights::new(1, 3);
            let [(p, before), (q, after)] = [
                evaluate(&chain[3 * k - 3..][..4], &u, &ends[1]),
                evaluate(&chain[3 * k..][..4], &u, &ends[0]),
            ];
            (p == q, before.normalize().dot(after.normalize()))
        };
        for piece in &PIECES {
            for k in 1..piece.chain.len() / 3 {
                let (same, cosine) = across(piece.chain, k);
                // Four decimals of Newell's numbers leave no more than this.
                assert!(same && cosine > 1.0 - 1e-12, "{same} {cosine}");
            }
        }
        // Control: a dent in a neighbouring row shows.
        let mut dented = BODY;
        dented[4][1][2] += 0.01;
        assert!(across(&dented, 1).1 < 1.0 - 1e-9);
    }
}

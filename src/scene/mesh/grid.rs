//! Triangles of a rectangular grid of vertices.

use rayon::prelude::*;

/// Two triangles for each of `rows` x `cols` quads, counter-clockwise seen from
/// the side to which (along a row) x (from row to row) points.
///
/// `index(i, j)` is the vertex at row i in 0..=rows and column j in 0..=cols. It
/// may send several (i, j) to one vertex, to close a ring or to join a row in
/// one pole; a triangle with two equal corners is left out.
pub(super) fn triangles(
    rows: u32,
    cols: u32,
    index: impl Fn(u32, u32) -> u32 + Sync,
) -> Vec<[u32; 3]> {
    let index = &index;
    corners(rows, cols, index)
        .map(|triangle| triangle.map(|[i, j]| index(i, j)))
        .collect()
}

/// The same triangles over a grid of (`rows` + 1) x (`cols` + 1) texture coordinates, row
/// after row, as [`uvs`] gives them: no two of these are one, so a texture may have a seam
/// where the vertices have none.
pub(super) fn uv_triangles(
    rows: u32,
    cols: u32,
    index: impl Fn(u32, u32) -> u32 + Sync,
) -> Vec<[u32; 3]> {
    corners(rows, cols, &index)
        .map(|triangle| triangle.map(|[i, j]| i * (cols + 1) + j))
        .collect()
}

/// `uv(i, j)` for each row i in 0..=`rows` and column j in 0..=`cols`.
pub(super) fn uvs(rows: u32, cols: u32, uv: impl Fn(f64, f64) -> [f64; 2] + Sync) -> Vec<[f64; 2]> {
    let uv = &uv;
    (0..=rows)
        .into_par_iter()
        .flat_map_iter(|i| (0..=cols).map(move |j| uv(f64::from(i), f64::from(j))))
        .collect()
}

/// Rows and columns of the corners of each triangle.
fn corners(
    rows: u32,
    cols: u32,
    index: &(impl Fn(u32, u32) -> u32 + Sync),
) -> impl ParallelIterator<Item = [[u32; 2]; 3]> {
    let same = move |[a, b]: [u32; 2], [c, d]: [u32; 2]| index(a, b) == index(c, d);
    (0..rows).into_par_iter().flat_map_iter(move |i| {
        (0..cols).flat_map(move |j| {
            let [a, b] = [[i, j], [i, j + 1]];
            let [d, c] = [[i + 1, j], [i + 1, j + 1]];
            let first = (!same(a, b)).then_some([a, b, c]);
            let second = (!same(c, d)).then_some([a, c, d]);
            first.into_iter().chain(second)
        })
    })
}

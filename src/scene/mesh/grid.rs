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
    (0..rows)
        .into_par_iter()
        .flat_map_iter(|i| {
            (0..cols).flat_map(move |j| {
                let [a, b] = [index(i, j), index(i, j + 1)];
                let [d, c] = [index(i + 1, j), index(i + 1, j + 1)];
                let first = (a != b).then_some([a, b, c]);
                let second = (c != d).then_some([a, c, d]);
                first.into_iter().chain(second)
            })
        })
        .collect()
}

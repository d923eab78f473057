//! Where on a texture a place of a triangle lies.

use super::camera::Ray;
use super::hit::Hit;
use super::real::Real;
use super::triangle_rows::triangle_at;
use super::vector::Vec3;
use super::{triangle, triangle_textbook};
use crate::flat::Flat;
use crate::tier::Formulas;

/// The texture coordinates of the place where a triangle was hit: those of its corners,
/// weighted. None where all of these are 0, 0: so has it who has none.
pub fn triangle_coordinates<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Option<[f32; 2]> {
    if hit.id < flat.first_triangle() || flat.vertex_uvs.is_empty() {
        return None;
    }
    let corners = flat.triangles[hit.row as usize];
    let [a, b, c] = corners
        .vertices
        .map(|vertex| flat.vertex_uvs[vertex as usize]);
    if [a, b, c] == [[0.0; 2]; 3] {
        return None;
    }
    let triangle = triangle_at(flat, corners, hit.time);
    let weights: Vec3<R> = match R::FORMULAS {
        Formulas::Textbook => triangle_textbook::triangle_weights(ray, &triangle),
        _ => triangle::triangle_weights(ray, &triangle),
    };
    let parts = weights.to_f32();
    Some([
        (a[0] * parts.x + b[0] * parts.y) + c[0] * parts.z,
        (a[1] * parts.x + b[1] * parts.y) + c[1] * parts.z,
    ])
}

//! Normals interpolated between the corners of a triangle.

use super::vector::{Vec3, dot_product, face_viewer, unit_vector};
use crate::layout::Corners;

/// The shading normal of the triangle with these corners: their normals weighted,
/// on the side of the triangle that faces the viewer. Where the corners have no
/// normals, the flat one.
pub fn shading_normal(
    vertex_normals: &[[f32; 3]],
    corners: Corners,
    weights: Vec3<f32>,
    flat: Vec3<f32>,
    direction: Vec3<f32>,
) -> Vec3<f32> {
    if vertex_normals.is_empty() {
        return face_viewer(flat, direction);
    }
    let [a, b, c] = corners
        .vertices
        .map(|vertex| Vec3::from(vertex_normals[vertex as usize]));
    let blend = (a * weights.x + b * weights.y) + c * weights.z;
    if dot_product(blend, blend) == 0.0 {
        return face_viewer(flat, direction);
    }
    let normal = unit_vector(blend);
    if dot_product(normal, face_viewer(flat, direction)) < 0.0 {
        return -normal;
    }
    normal
}

//! Normals interpolated between the corners of a triangle.

use super::vector::{Vec3, dot_product, face_viewer, unit_vector};
use crate::layout::CornerNormals;

/// The shading normal of triangle `index`: the corners' normals weighted, on
/// the side of the triangle that faces the viewer. Where the corners have no
/// normals, the flat one.
pub fn shading_normal(
    corner_normals: &[CornerNormals],
    index: u32,
    weights: Vec3<f32>,
    flat: Vec3<f32>,
    direction: Vec3<f32>,
) -> Vec3<f32> {
    let Some(corners) = corner_normals.get(index as usize) else {
        return face_viewer(flat, direction);
    };
    let blend = (Vec3::from(corners.a) * weights.x + Vec3::from(corners.b) * weights.y)
        + Vec3::from(corners.c) * weights.z;
    if dot_product(blend, blend) == 0.0 {
        return face_viewer(flat, direction);
    }
    let normal = unit_vector(blend);
    if dot_product(normal, face_viewer(flat, direction)) < 0.0 {
        return -normal;
    }
    normal
}

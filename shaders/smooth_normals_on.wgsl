// Normals interpolated between the corners of a triangle.

@group(2) @binding(5) var<storage, read> corner_normals: array<CornerNormals>;

// The shading normal of triangle `index`: the corners' normals weighted, on
// the side of the triangle that faces the viewer. Where the corners have no
// normals, the flat one.
fn shading_normal(
    index: u32,
    weights: vec3<f32>,
    flat_normal: vec3<f32>,
    direction: vec3<f32>,
) -> vec3<f32> {
    let corners = corner_normals[index];
    let blend = (corners.a * weights.x + corners.b * weights.y) + corners.c * weights.z;
    if dot_product(blend, blend) == 0.0 {
        return face_viewer(flat_normal, direction);
    }
    let normal = unit_vector(blend);
    if dot_product(normal, face_viewer(flat_normal, direction)) < 0.0 {
        return -normal;
    }
    return normal;
}

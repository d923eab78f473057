// Normals interpolated between the corners of a triangle.

// The normal at a vertex; zero where it has none.
fn vertex_normal_at(vertex: u32) -> vec3<f32> {
    return floats_at(tables.vertex_normals, vertex).xyz;
}

// The shading normal of the triangle with these corners: their normals weighted,
// on the side of the triangle that faces the viewer. Where the corners have no
// normals, the flat one.
fn shading_normal(
    corners: vec4<u32>,
    weights: vec3<f32>,
    flat_normal: vec3<f32>,
    direction: vec3<f32>,
) -> vec3<f32> {
    let a = vertex_normal_at(corners.x);
    let b = vertex_normal_at(corners.y);
    let c = vertex_normal_at(corners.z);
    let blend = (a * weights.x + b * weights.y) + c * weights.z;
    if dot_product_f32(blend, blend) == 0.0 {
        return face_viewer_f32(flat_normal, direction);
    }
    let normal = unit_vector_f32(blend);
    if dot_product_f32(normal, face_viewer_f32(flat_normal, direction)) < 0.0 {
        return -normal;
    }
    return normal;
}

// A scene without smooth normals: every triangle is flat.

fn shading_normal(
    corners: vec4<u32>,
    weights: vec3<f32>,
    flat_normal: vec3<f32>,
    direction: vec3<f32>,
) -> vec3<f32> {
    return face_viewer_f32(flat_normal, direction);
}

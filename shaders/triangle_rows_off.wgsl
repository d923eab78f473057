// Triangles that stand still.

// The triangle with these corners.
fn triangle_at(corners: vec4<u32>) -> Triangle {
    return Triangle(
        reals_at(tables.vertices, corners.x).xyz,
        reals_at(tables.vertices, corners.y).xyz,
        reals_at(tables.vertices, corners.z).xyz,
    );
}

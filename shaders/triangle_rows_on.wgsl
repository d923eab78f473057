// Triangles, where they are at the sample's time. Those that share a vertex go the same way,
// so it is rounded alike for each of them, and a mesh stays watertight.

// The triangle with these corners.
fn triangle_at(corners: vec4<u32>) -> Triangle {
    return Triangle(
        moved(reals_at(tables.vertices, corners.x).xyz, corners.w),
        moved(reals_at(tables.vertices, corners.y).xyz, corners.w),
        moved(reals_at(tables.vertices, corners.z).xyz, corners.w),
    );
}

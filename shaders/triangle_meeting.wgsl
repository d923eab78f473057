// Where a ray meets a triangle, within the triangle's own box.

// Where the ray meets the triangle.
fn meet_triangle(probe: Probe, triangle: Triangle) -> Meeting {
    let t = intersect_triangle(probe.ray, probe.shear, triangle);
    if t < MISS {
        let own = triangle_box(vec3<f32>(triangle.a), vec3<f32>(triangle.b), vec3<f32>(triangle.c));
        return certain_meeting(clamp_to_box(probe.slabs, own, t));
    }
    return certain_meeting(MISS);
}

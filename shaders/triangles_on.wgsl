// All triangles: which one is nearest, and what is found there.

@group(2) @binding(4) var<storage, read> triangles: array<Triangle>;

// Tests one triangle, by its index, within its own box.
fn test_triangle(probe: Probe, index: u32, hit: ptr<function, Hit>) {
    let triangle = triangles[index];
    var t = intersect_triangle(probe.ray, probe.shear, triangle);
    if t < MISS {
        t = clamp_to_box(probe.slabs, triangle_box(vec3<f32>(triangle.a), vec3<f32>(triangle.b), vec3<f32>(triangle.c)), t);
    }
    keep_nearer(hit, t, dispatch.triangles.first_id + index);
}

// Tests every triangle of the dispatch.
fn closest_triangle(probe: Probe, hit: ptr<function, Hit>) {
    for (var i = dispatch.triangles.begin; i < dispatch.triangles.end; i++) {
        test_triangle(probe, i, hit);
    }
}

// The surface of the triangle that was hit.
fn triangle_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
    let index = hit.id - dispatch.triangles.first_id;
    if index >= dispatch.triangles.end {
        return;
    }
    let triangle = triangles[index];
    let weights = triangle_weights(ray, triangle);
    (*surface).position = vec3<f32>(triangle_point(triangle, weights));
    (*surface).normal = shading_normal(
        index,
        vec3<f32>(weights),
        vec3<f32>(triangle_normal(triangle)),
        vec3<f32>(ray.direction),
    );
}

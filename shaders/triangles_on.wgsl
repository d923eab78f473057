// All triangles: which one is nearest, and what is found there.

@group(2) @binding(4) var<storage, read> triangles: array<Triangle>;

// Tests every triangle of the dispatch.
fn closest_triangle(ray: Ray, hit: ptr<function, Hit>) {
    let shear = shear_of(ray);
    for (var i = dispatch.triangles.begin; i < dispatch.triangles.end; i++) {
        let t = intersect_triangle(ray, shear, triangles[i]);
        keep_nearer(hit, t, dispatch.triangles.first_id + i);
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

// All spheres: which one is nearest, and what is found there.

@group(2) @binding(1) var<storage, read> spheres: array<Sphere>;

// Tests every sphere of the dispatch.
fn closest_sphere(ray: Ray, hit: ptr<function, Hit>) {
    for (var i = dispatch.spheres.begin; i < dispatch.spheres.end; i++) {
        keep_nearer(hit, intersect_sphere(ray, spheres[i]), dispatch.spheres.first_id + i);
    }
}

// The surface of the sphere that was hit.
fn sphere_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
    let index = hit.id - dispatch.spheres.first_id;
    if index >= dispatch.spheres.end {
        return;
    }
    let sphere = spheres[index];
    let normal = sphere_normal(ray, sphere, hit.t);
    (*surface).position = vec3<f32>(sphere_point(sphere, normal));
    (*surface).normal = vec3<f32>(face_viewer(normal, ray.direction));
}

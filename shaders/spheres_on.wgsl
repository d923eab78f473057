// All spheres: which one is nearest, and what is found there.

@group(2) @binding(1) var<storage, read> spheres: array<Sphere>;

// Tests one sphere, by its index, within its own box.
fn test_sphere(probe: Probe, index: u32, hit: ptr<function, Hit>) {
    let sphere = spheres[index];
    var t = intersect_sphere(probe.ray, sphere);
    if t < MISS {
        t = clamp_to_box(probe.slabs, ball_box(vec3<f32>(sphere.center), f32(sphere.radius)), t);
    }
    keep_nearer(hit, t, dispatch.spheres.first_id + index);
}

// Tests every sphere of the dispatch.
fn closest_sphere(probe: Probe, hit: ptr<function, Hit>) {
    for (var i = dispatch.spheres.begin; i < dispatch.spheres.end; i++) {
        test_sphere(probe, i, hit);
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

// All planes: which one is nearest, and what is found there.

@group(2) @binding(2) var<storage, read> planes: array<Plane>;

// Tests every plane of the dispatch.
fn closest_plane(probe: Probe, hit: ptr<function, Hit>) {
    for (var i = dispatch.planes.begin; i < dispatch.planes.end; i++) {
        let t = intersect_plane(probe.ray, planes[i].point, planes[i].normal);
        keep_nearer(hit, t, dispatch.planes.first_id + i);
    }
}

// The surface of the plane that was hit.
fn plane_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
    let index = hit.id - dispatch.planes.first_id;
    if index >= dispatch.planes.end {
        return;
    }
    (*surface).position = vec3<f32>(ray.origin + ray.direction * hit.t);
    (*surface).normal = vec3<f32>(face_viewer(planes[index].normal, ray.direction));
}

// All planes: which one is nearest, and what is found there.

// Tests every plane of the dispatch.
fn closest_plane(probe: Probe, hit: ptr<function, Hit>) {
    let end = hidden_end(dispatch.planes.end, probe.slabs.inverse.x);
    for (var row = dispatch.planes.begin; row < end; row++) {
        let meeting = meet_plane(probe, plane_at(row));
        count_test(hit);
        if may_be_closest(*hit, meeting) {
            keep_nearer(hit, meeting, tables.first_plane + row, row);
        }
    }
}

// The surface of the plane that was hit.
fn plane_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
    if hit.id < tables.first_plane || hit.id >= tables.first_disk {
        return;
    }
    let position = vec3<f32>(ray.origin + ray.direction * hit.t);
    (*surface).position = position;
    (*surface).normal = vec3<f32>(face_viewer(plane_at(hit.row).normal, ray.direction));
    (*surface).facing = (*surface).normal;
    let reach = taxicab_length_f32(position);
    (*surface).reach = reach + taxicab_length_f32(vec3<f32>(ray.origin));
}

// Whether the ray comes to the plane that it hit from behind.
fn plane_is_left(ray: Ray, hit: Hit) -> bool {
    if hit.id < tables.first_plane || hit.id >= tables.first_disk {
        return false;
    }
    return dot_product(plane_at(hit.row).normal, ray.direction) > 0.0;
}

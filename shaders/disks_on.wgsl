// All disks: which one is nearest, and what is found there.

@group(2) @binding(3) var<storage, read> disks: array<Disk>;

// Tests every disk of the dispatch.
fn closest_disk(ray: Ray, hit: ptr<function, Hit>) {
    for (var i = dispatch.disks.begin; i < dispatch.disks.end; i++) {
        keep_nearer(hit, intersect_disk(ray, disks[i]), dispatch.disks.first_id + i);
    }
}

// The surface of the disk that was hit.
fn disk_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
    let index = hit.id - dispatch.disks.first_id;
    if index >= dispatch.disks.end {
        return;
    }
    (*surface).position = vec3<f32>(ray.origin + ray.direction * hit.t);
    (*surface).normal = vec3<f32>(face_viewer(disks[index].normal, ray.direction));
}

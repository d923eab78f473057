// All disks: which one is nearest, and what is found there.

@group(2) @binding(3) var<storage, read> disks: array<Disk>;

// Tests one disk, by its index, within its own box.
fn test_disk(probe: Probe, index: u32, hit: ptr<function, Hit>) {
    let disk = disks[index];
    var t = intersect_disk(probe.ray, disk);
    if t < MISS {
        t = clamp_to_box(probe.slabs, ball_box(vec3<f32>(disk.center), f32(disk.radius)), t);
    }
    keep_nearer(hit, t, dispatch.disks.first_id + index);
}

// Tests every disk of the dispatch.
fn closest_disk(probe: Probe, hit: ptr<function, Hit>) {
    for (var i = dispatch.disks.begin; i < dispatch.disks.end; i++) {
        test_disk(probe, i, hit);
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

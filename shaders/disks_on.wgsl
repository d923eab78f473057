// All disks: which one is nearest, and what is found there.

// Tests the disk in a row of the table.
fn test_disk(probe: Probe, row: u32, hit: ptr<function, Hit>) {
    let meeting = meet_disk(probe, disk_at(row));
    count_test(hit);
    if may_be_closest(*hit, meeting) {
        keep_nearer(hit, meeting, word_at(tables.disk_ids, row), row);
    }
}

// Tests the disks in some rows, and tells the row that it came to: a driver may stop
// a loop.
fn test_disks(probe: Probe, begin: u32, end: u32, hit: ptr<function, Hit>) -> u32 {
    var row = begin;
    for (; row < end; row++) {
        test_disk(probe, row, hit);
    }
    return row;
}

// The surface of the disk that was hit.
fn disk_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
    if hit.id < tables.first_disk || hit.id >= tables.first_triangle {
        return;
    }
    let disk = disk_at(hit.row);
    (*surface).position = vec3<f32>(ray.origin + ray.direction * hit.t);
    (*surface).normal = vec3<f32>(face_viewer(disk.normal, ray.direction));
    (*surface).facing = (*surface).normal;
    let reach = taxicab_length_f32(vec3<f32>(disk.center)) + f32(disk.radius);
    (*surface).reach = reach + taxicab_length_f32(vec3<f32>(ray.origin));
}

// Whether the ray comes to the disk that it hit from behind.
fn disk_is_left(ray: Ray, hit: Hit) -> bool {
    if hit.id < tables.first_disk || hit.id >= tables.first_triangle {
        return false;
    }
    return dot_product(disk_at(hit.row).normal, ray.direction) > 0.0;
}

// All spheres: which one is nearest, and what is found there.

// Near the surface of a large sphere, what of its radius counts as its reach: roundings are
// parts of the way to the point, and only the squares of roundings of the radius.
const NEAR_REACH: f32 = 1.0 / 1048576.0;

// Tests the sphere in a row of the table.
fn test_sphere(probe: Probe, row: u32, hit: ptr<function, Hit>) {
    let meeting = meet_sphere(probe, sphere_at(row));
    count_test(hit);
    if may_be_closest(*hit, meeting) {
        keep_nearer(hit, meeting, word_at(tables.sphere_ids, row), row);
    }
}

// Tests the spheres in some rows, and tells the row that it came to: a driver may stop
// a loop.
fn test_spheres(probe: Probe, begin: u32, end: u32, hit: ptr<function, Hit>) -> u32 {
    var row = begin;
    for (; row < end; row++) {
        test_sphere(probe, row, hit);
    }
    return row;
}

// The surface of the sphere that was hit.
fn sphere_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
    if hit.id >= tables.first_plane {
        return;
    }
    let sphere = sphere_at(hit.row);
    let normal = sphere_normal(ray, sphere, hit.t);
    let position = vec3<f32>(sphere_point(ray, sphere, normal, hit.t));
    (*surface).position = position;
    (*surface).normal = vec3<f32>(face_viewer(normal, ray.direction));
    (*surface).facing = (*surface).normal;
    let radius = f32(sphere.radius);
    var reach = taxicab_length_f32(vec3<f32>(sphere.center)) + radius;
    if starts_near(sphere, sphere_power(ray.origin, sphere)) {
        reach = taxicab_length_f32(position) + radius * NEAR_REACH;
    }
    (*surface).reach = reach + taxicab_length_f32(vec3<f32>(ray.origin));
}

// Whether the ray comes to the sphere that it hit from within.
fn sphere_is_left(ray: Ray, hit: Hit) -> bool {
    if hit.id >= tables.first_plane {
        return false;
    }
    return dot_product(sphere_normal(ray, sphere_at(hit.row), hit.t), ray.direction) > 0.0;
}

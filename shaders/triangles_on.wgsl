// All triangles: which one is nearest, and what is found there.

// The rows of the three vertices of the triangle in a row of the table, and its id.
fn corners_at(row: u32) -> vec4<u32> {
    return fetch(tables.triangles + row);
}

// Tests the triangle in a row of the table.
fn test_triangle(probe: Probe, row: u32, hit: ptr<function, Hit>) {
    let corners = corners_at(row);
    let meeting = meet_triangle(probe, triangle_at(corners));
    count_test(hit);
    if may_be_closest(*hit, meeting) {
        keep_nearer(hit, meeting, corners.w, row);
    }
}

// Tests the triangles in some rows, and tells the row that it came to: a driver may stop
// a loop.
fn test_triangles(probe: Probe, begin: u32, end: u32, hit: ptr<function, Hit>) -> u32 {
    var row = begin;
    for (; row < end; row++) {
        test_triangle(probe, row, hit);
    }
    return row;
}

// The surface of the triangle that was hit.
fn triangle_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
    if hit.id < tables.first_triangle {
        return;
    }
    let corners = corners_at(hit.row);
    let triangle = triangle_at(corners);
    let weights = triangle_weights(ray, triangle);
    (*surface).position = vec3<f32>(triangle_point(triangle, weights));
    let normal = vec3<f32>(triangle_normal(triangle));
    let direction = vec3<f32>(ray.direction);
    (*surface).normal = shading_normal(corners, vec3<f32>(weights), normal, direction);
    (*surface).facing = face_viewer_f32(normal, direction);
    let a = taxicab_length_f32(vec3<f32>(triangle.a));
    let b = taxicab_length_f32(vec3<f32>(triangle.b));
    let c = taxicab_length_f32(vec3<f32>(triangle.c));
    let reach = greatest(greatest(a, b), c);
    (*surface).reach = reach + taxicab_length_f32(vec3<f32>(ray.origin));
}

// Whether the ray comes to the triangle that it hit from behind: from where its corners are
// seen clockwise.
fn triangle_is_left(ray: Ray, hit: Hit) -> bool {
    if hit.id < tables.first_triangle {
        return false;
    }
    let normal = triangle_normal(triangle_at(corners_at(hit.row)));
    return dot_product(normal, ray.direction) > 0.0;
}

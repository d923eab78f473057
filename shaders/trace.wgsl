// One invocation a pixel: from its ray to its colour.
//
// A tile is a band of rows. It takes one dispatch of `render_tile`; or, where one cannot
// test everything, several of `trace_tile`, with the closest hit carried in `hits`, and
// then one of `shade_tile`.

// Tests the primitives in some rows of a kind's table, as src/flat.rs counts kinds,
// and tells the row that it came to.
fn test_rows(probe: Probe, kind: u32, begin: u32, end: u32, hit: ptr<function, Hit>) -> u32 {
    if kind == 0u {
        return test_spheres(probe, begin, end, hit);
    }
    if kind == 1u {
        return test_disks(probe, begin, end, hit);
    }
    return test_triangles(probe, begin, end, hit);
}

// What the ray sees at its hit.
fn shade_hit(ray: Ray, hit: Hit) -> Pixel {
    var surface: Surface;
    sphere_surface(ray, hit, &surface);
    plane_surface(ray, hit, &surface);
    disk_surface(ray, hit, &surface);
    triangle_surface(ray, hit, &surface);
    let material = material_of(hit.id);
    let depth = f32(hit.t * vector_length(ray.direction));
    let color = scattered_light(surface, material.albedo);
    return Pixel(color, depth, surface.normal, hit.id, surface.position, hit.tests);
}

// What the ray sees that meets nothing.
fn shade_miss(ray: Ray, hit: Hit) -> Pixel {
    let color = background_color(vec3<f32>(ray.direction));
    return Pixel(color, 0.0, vec3<f32>(), NO_HIT, vec3<f32>(), hit.tests);
}

// What the ray sees.
fn shade(ray: Ray, hit: Hit) -> Pixel {
    if hit.id == NO_HIT {
        return shade_miss(ray, hit);
    }
    return shade_hit(ray, hit);
}

// The bits 0, 2 and 4 of an index, moved together: one coordinate of a place on
// Morton's curve, the other being that of half the index.
fn even_bits(index: u32) -> u32 {
    return (index & 1u) | ((index >> 1u) & 2u) | ((index >> 2u) & 4u);
}

// The pixel of an invocation, in the tile. A workgroup covers 8 x 8 pixels along
// Morton's curve, so that neighbours run together. The rows of workgroups are dealt
// out to slices, so that what a driver hands to one thread lies all over the tile.
fn tile_pixel(workgroup: vec3<u32>, lane: u32) -> vec2<u32> {
    let down = workgroup.y * dispatch.slices + workgroup.z;
    return vec2<u32>(8u * workgroup.x + even_bits(lane), 8u * down + even_bits(lane >> 1u));
}

// The closest hit so far of a pixel of the tile.
fn hit_at(index: u32) -> Hit {
    let record = hits[index];
    var hit = no_hit();
    hit.t = real(record.t);
    hit.id = record.id;
    hit.row = record.row;
    hit.tests = record.tests;
    return hit;
}

// Finds the closest hit of the tile's pixels among the primitives of the
// dispatch and of those before it.
@compute @workgroup_size(64)
fn trace_tile(
    @builtin(workgroup_id) workgroup: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let at = tile_pixel(workgroup, lane);
    if at.x >= dispatch.size.x || at.y >= dispatch.rows {
        return;
    }
    let index = at.y * dispatch.size.x + at.x;
    var hit = no_hit();
    if dispatch.fresh == 0u {
        hit = hit_at(index);
        load_cursor(index, &hit);
    }
    let y = dispatch.first_row + at.y;
    let ray = camera_ray(dispatch.size, at.x, y);
    hit.tile = tile_of(dispatch.size, at.x, y);
    closest_hit(probe_of(ray), &hit);
    hits[index] = HitRecord(f32(hit.t), hit.id, hit.row, hit.tests);
    store_cursor(index, hit);
    keep_counts(index, hit);
}

// Colours the tile's pixels.
@compute @workgroup_size(64)
fn shade_tile(
    @builtin(workgroup_id) workgroup: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let at = tile_pixel(workgroup, lane);
    if at.x >= dispatch.size.x || at.y >= dispatch.rows {
        return;
    }
    let index = at.y * dispatch.size.x + at.x;
    let hit = hit_at(index);
    let ray = camera_ray(dispatch.size, at.x, dispatch.first_row + at.y);
    pixels[index] = shade(ray, hit);
}

// Finds the closest hit of the tile's pixels and colours them at once.
@compute @workgroup_size(64)
fn render_tile(
    @builtin(workgroup_id) workgroup: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let at = tile_pixel(workgroup, lane);
    if at.x >= dispatch.size.x || at.y >= dispatch.rows {
        return;
    }
    let index = at.y * dispatch.size.x + at.x;
    let y = dispatch.first_row + at.y;
    let ray = camera_ray(dispatch.size, at.x, y);
    var hit = no_hit();
    hit.tile = tile_of(dispatch.size, at.x, y);
    closest_hit(probe_of(ray), &hit);
    pixels[index] = shade(ray, hit);
    keep_counts(index, hit);
}

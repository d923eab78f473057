// The pixels of a tile, one invocation each.
//
// A tile is a band of rows. It takes one dispatch of `render_tile`; or, where one cannot
// test everything, several of `trace_tile`, with the closest hit carried in `hits`, and
// then one of `shade_tile`.

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
    hit.t = record.t;
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
        load_doubt(index, &hit);
    }
    let y = dispatch.first_row + at.y;
    let ray = camera_ray(dispatch.size, at.x, y);
    hit.tile = tile_of(dispatch.size, at.x, y);
    closest_hit(probe_of(ray), &hit);
    hits[index] = HitRecord(hit.t, hit.id, hit.row, hit.tests);
    store_cursor(index, hit);
    store_doubt(index, hit);
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
    var hit = hit_at(index);
    load_doubt(index, &hit);
    let ray = camera_ray(dispatch.size, at.x, dispatch.first_row + at.y);
    pixels[index] = shade(ray, hit);
    list_doubtful(index, hit);
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
    list_doubtful(index, hit);
    keep_counts(index, hit);
}

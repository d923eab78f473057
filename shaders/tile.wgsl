// The pixels of a tile, one invocation each.
//
// A tile is a band of rows. It takes one dispatch of `render_tile`; or, where one cannot
// test everything, several of `trace_tile`, with the closest hit carried in `hits`, and
// then one of `shade_tile`.

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

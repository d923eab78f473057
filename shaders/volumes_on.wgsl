// A list of bounding volumes, each before what it holds: a ray that misses one skips
// all of that.

// How far each pixel's ray has come in the list, from one dispatch to the next.
@group(0) @binding(6) var<storage, read_write> cursors: array<vec2<u32>>;

// As in src/layout.rs; a test holds them to it.
const BALL: u32 = 3u;

// An entry of the list.
fn volume_at(entry: u32) -> Volume {
    let quad = fetch(tables.volumes + entry);
    return Volume(quad.x, quad.y, quad.z, quad.w);
}

// The ball in a row of the table.
fn ball_at(row: u32) -> Sphere {
    let quad = reals_at(tables.balls, row);
    return Sphere(quad.xyz, quad.w);
}

// The box in a row of the table.
fn box_at(row: u32) -> BoxRecord {
    let low = floats_at(tables.boxes, 2u * row).xyz;
    return BoxRecord(low, floats_at(tables.boxes, 2u * row + 1u).xyz);
}

// Whether the ray meets the volume, however far away.
fn meets_volume(probe: Probe, volume: Volume) -> bool {
    if volume.kind == BALL {
        return meets_ball(probe.ray, ball_at(volume.begin));
    }
    let bounds = box_at(volume.begin);
    let interval = clip_to_box(probe.slabs, bounds.low, bounds.high);
    return interval.enter <= interval.exit;
}

// The nearest of all primitives: of the planes, which no volume holds, then of
// those in the list.
//
// One loop, of which each turn tests one volume or one primitive: so lanes that are
// at different entries do not add up to more turns than a driver allows.
fn closest_in_volumes(probe: Probe, hit: ptr<function, Hit>) {
    closest_plane(probe, hit);
    var entry = (*hit).entry;
    var done = (*hit).done;
    for (var step = 0u; step < dispatch.steps && entry < tables.volume_count; step++) {
        let volume = volume_at(entry);
        if volume.kind >= BALL {
            let met = meets_volume(probe, volume);
            count_bound(hit, met);
            entry = select(volume.skip, entry + 1u, met);
        } else {
            test_row(probe, volume.kind, volume.begin + done, hit);
            done++;
            if volume.begin + done == volume.end {
                entry = volume.skip;
                done = 0u;
            }
        }
    }
    (*hit).entry = entry;
    (*hit).done = done;
    if dispatch.last == 1u && entry < tables.volume_count {
        (*hit).tests = GIVEN_UP;
    }
}

// Takes up where the ray was left.
fn load_cursor(index: u32, hit: ptr<function, Hit>) {
    (*hit).entry = cursors[index].x;
    (*hit).done = cursors[index].y;
}

// Leaves the ray where it is, unless it goes no further.
fn store_cursor(index: u32, hit: Hit) {
    if dispatch.last == 0u {
        cursors[index] = vec2<u32>(hit.entry, hit.done);
    }
}

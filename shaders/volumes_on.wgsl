// A list of bounding volumes, each before what it holds: a ray that misses one skips
// all of that.

// How far each pixel's ray has come in the list, from one dispatch to the next.
@group(0) @binding(6) var<storage, read_write> cursors: array<vec2<u32>>;

// As in src/layout.rs; a test holds them to it.
const BOX: u32 = 0x80000000u;
const LIST_KIND: u32 = 29u;

// Whether the ray meets the volume, however far away.
fn meets_volume(probe: Probe, bound: u32) -> bool {
    if (bound & BOX) == 0u {
        return meets_bounding_ball(probe, bound);
    }
    return meets_bounding_box(probe, bound ^ BOX);
}

// The nearest of all primitives: of the planes, which no volume holds, then of
// those in the list.
//
// At most so many steps, a volume or a primitive each, as the dispatch allows. In
// `done` are those that the ray has made within an entry: its volume, then its own
// primitives.
fn closest_in_volumes(probe: Probe, hit: ptr<function, Hit>) {
    closest_plane(probe, hit);
    var entry = (*hit).entry;
    var done = (*hit).done;
    var steps = dispatch.steps;
    while steps > 0u && entry < tables.volume_count {
        let volume = volume_at(entry);
        var met = true;
        if done == 0u {
            met = is_on_tile((*hit).tile, entry);
            if met && volume.bound != EVERYTHING {
                met = meets_volume(probe, volume.bound);
                count_bound(hit, met);
            }
            done = 1u;
            steps--;
        }
        let first = volume.first & ((1u << LIST_KIND) - 1u);
        let begin = first + done - 1u;
        let own = select(0u, volume.count - (done - 1u), met);
        let end = begin + min(own, steps);
        let row = test_rows(probe, volume.first >> LIST_KIND, begin, end, hit);
        done += row - begin;
        steps -= row - begin;
        if row < end {
            break;
        }
        if !met || row == first + volume.count {
            entry = select(volume.skip, entry + 1u, met);
            done = 0u;
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

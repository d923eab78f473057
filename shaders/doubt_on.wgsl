// What is not certain of a hit, where the formulas bound their error.
//
// Of each shape an interval of t is known in which the ray first meets it. Another shape
// whose interval begins before that of the nearest one ends is its rival. A ray with a
// rival, or with a wide interval, is in doubt. docs/numerics.md derives the intervals.

// The error of a ray's and a shape's numbers and of what is computed of them, in parts of
// how far the shape reaches from the camera and from where the ray starts.
const ERROR: f32 = 48.0 / 16777216.0;

// The width of an interval, in parts of t, from which on t is in doubt: far above what
// ordinary rays have, which is some 2^-17, and below what a picture shows.
const WIDE_INTERVAL: f32 = 1.0 / 4096.0;

// The pixels of the tile whose rays are in doubt: how many, then which.
@group(0) @binding(10) var<storage, read_write> doubtful: array<atomic<u32>>;

// The bounds of a pixel's closest hit, carried from one dispatch to the next.
@group(0) @binding(11) var<storage, read_write> bounds: array<vec3<f32>>;

// A meeting at t, as far as its formulas can tell.
fn certain_meeting(t: real) -> Meeting {
    return Meeting(t, t, t);
}

// The meeting at t, which is `error` off at most: in doubt where t may be 0.
fn meeting_within(t: real, error: real) -> Meeting {
    if t - error > 0.0 {
        return Meeting(t, t - error, t + error);
    }
    if t + error < 0.0 {
        return certain_meeting(MISS);
    }
    return doubtful_meeting(0.0);
}

// A meeting that may not take place, and not before `low`.
fn doubtful_meeting(low: real) -> Meeting {
    let ahead = select(0.0, low, low > 0.0);
    return Meeting(ahead, ahead, MISS);
}

// The meeting, as far as it is in the shape's own box.
//
// A bound may accept a ray far from the shape, such as one in the plane of a triangle.
// Which of those are tested would depend on the tree, and with them whether the ray is in
// doubt. No hit is lost: in f64 too, it counts only in the same box.
fn meeting_in_box(slabs: Slabs, own: Aabb, meeting: Meeting) -> Meeting {
    let interval = clip_to_box(slabs, own.low, own.high);
    if interval.enter > interval.exit {
        return certain_meeting(MISS);
    }
    let enter = real(interval.enter);
    let low = select(meeting.low, enter, meeting.low < enter);
    let t = select(meeting.t, low, meeting.t < low);
    let high = select(meeting.high, t, meeting.high < t);
    return Meeting(t, low, high);
}

// Whether a meeting may be the closest. A tie is for `keep_nearer` to settle, by the ids,
// which are read only now.
fn may_be_closest(hit: Hit, meeting: Meeting) -> bool {
    return meeting.low <= hit.high && meeting.low < MISS;
}

// Keeps a hit if it is certain and nearer; else, or what was kept before, it is a rival.
fn keep_nearer(hit: ptr<function, Hit>, meeting: Meeting, id: u32, row: u32) {
    let nearer = meeting.high < MISS && meeting.t < (*hit).t;
    let other = select(meeting.low, (*hit).low, nearer);
    if other < (*hit).rival {
        (*hit).rival = other;
    }
    if nearer {
        (*hit).t = meeting.t;
        (*hit).low = meeting.low;
        (*hit).high = meeting.high;
        (*hit).id = id;
        (*hit).row = row;
    }
}

// The t after which nothing can be the closest.
fn limit_of(hit: Hit) -> real {
    return hit.high;
}

// Whether the hit, or that there is none, is in doubt.
fn is_in_doubt(hit: Hit) -> bool {
    let rivalled = hit.rival <= hit.high && hit.rival < MISS;
    let wide = hit.id != NO_HIT && hit.high - hit.low > hit.t * WIDE_INTERVAL;
    return rivalled || wide;
}

// Takes up the bounds of the pixel's hit.
fn load_doubt(index: u32, hit: ptr<function, Hit>) {
    (*hit).low = bounds[index].x;
    (*hit).high = bounds[index].y;
    (*hit).rival = bounds[index].z;
}

// Leaves the bounds of the pixel's hit.
fn store_doubt(index: u32, hit: Hit) {
    bounds[index] = vec3<f32>(hit.low, hit.high, hit.rival);
}

// Puts the pixel on the list if its ray is in doubt.
fn list_doubtful(index: u32, hit: Hit) {
    if is_in_doubt(hit) {
        doubtful[1u + atomicAdd(&doubtful[0], 1u)] = index;
    }
}

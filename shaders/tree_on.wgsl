// The bounding volume hierarchy: only what the ray comes near is tested.

@group(2) @binding(6) var<storage, read> pairs: array<Pair>;

// Pairs that can wait while others are visited; the builder builds no deeper.
const STACK: u32 = 64u;

// Pairs that a ray visits at most. A tree of any use is left long before; past
// it the ray is given up, and said to be. Below lavapipe's 65,535 iterations.
const MOST_VISITS: u32 = 30000u;

// In place of a hit's tests: the ray was given up.
const GIVEN_UP: u32 = 0xffffffffu;

// Tests one primitive that is not a plane, by its id.
fn test_primitive(probe: Probe, id: u32, hit: ptr<function, Hit>) {
    if id < dispatch.planes.first_id {
        test_sphere(probe, id, hit);
    } else if id < dispatch.triangles.first_id {
        test_disk(probe, id - dispatch.disks.first_id, hit);
    } else {
        test_triangle(probe, id - dispatch.triangles.first_id, hit);
    }
}

// Tests a leaf's primitives.
fn test_leaf(probe: Probe, first: u32, count: u32, hit: ptr<function, Hit>) {
    for (var i = first; i < first + count; i++) {
        test_primitive(probe, indices[dispatch.primitives + i], hit);
    }
}

// Whether something in the box may be nearer than the hit, or as near.
fn may_be_nearer(interval: Interval, hit: Hit) -> bool {
    return interval.enter <= interval.exit && real(interval.enter) <= hit.t;
}

// The nearest of all primitives: of the planes, which no volume holds, then of
// those in the tree, the nearer child of each pair first.
fn closest_hit(probe: Probe, hit: ptr<function, Hit>) {
    closest_plane(probe, hit);
    var waiting: array<u32, STACK>;
    var entered: array<f32, STACK>;
    var depth = 0u;
    var at = 0u;
    for (var visit = 0u; visit < MOST_VISITS; visit++) {
        let pair = pairs[at];
        let left = clip_to_box(probe.slabs, pair.left_low, pair.left_high);
        let right = clip_to_box(probe.slabs, pair.right_low, pair.right_high);
        var to_left = may_be_nearer(left, *hit);
        var to_right = may_be_nearer(right, *hit);
        if to_left && pair.left_count > 0u {
            test_leaf(probe, pair.left, pair.left_count, hit);
            to_left = false;
        }
        if to_right && pair.right_count > 0u {
            test_leaf(probe, pair.right, pair.right_count, hit);
            to_right = false;
        }
        if to_left && to_right {
            let left_first = left.enter <= right.enter;
            waiting[depth] = select(pair.left, pair.right, left_first);
            entered[depth] = select(left.enter, right.enter, left_first);
            depth++;
            at = select(pair.right, pair.left, left_first);
            continue;
        }
        if to_left || to_right {
            at = select(pair.right, pair.left, to_left);
            continue;
        }
        loop {
            if depth == 0u {
                return;
            }
            depth--;
            if real(entered[depth]) <= (*hit).t {
                break;
            }
        }
        at = waiting[depth];
    }
    (*hit).tests = GIVEN_UP;
}

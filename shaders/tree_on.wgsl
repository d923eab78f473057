// The bounding volume hierarchy: only what the ray comes near is tested.

// Pairs that can wait while others are visited; the builder builds no deeper.
const STACK: u32 = 64u;

// Pairs that a ray visits at most. A tree of any use is left long before; past
// it the ray is given up, and said to be. Below lavapipe's 65,535 iterations.
const MOST_VISITS: u32 = 30000u;

// As in src/layout.rs; a test holds them to it.
const LEAF: u32 = 0x80000000u;
const LEAF_KIND: u32 = 29u;
const LEAF_COUNT: u32 = 26u;
const NOWHERE: u32 = 0xffffffffu;

// The two children of a pair: their boxes, and what they are.
struct Children {
    left_low: vec3<f32>,
    left_high: vec3<f32>,
    right_low: vec3<f32>,
    right_high: vec3<f32>,
    left: u32,
    right: u32,
}

// The planes of both boxes across one axis: the left one's low and high, the right
// one's. Origin and offset are whole steps, so nothing is rounded.
fn axis_planes(origin: u32, offsets: u32) -> vec4<f32> {
    let step = bitcast<f32>((origin >> 24u) << 23u);
    let start = bitcast<i32>(origin << 8u) >> 8u;
    let offset = vec4<u32>(offsets, offsets >> 8u, offsets >> 16u, offsets >> 24u) & vec4<u32>(255u);
    return vec4<f32>(vec4<i32>(start) + vec4<i32>(offset)) * step;
}

// The children of a pair.
fn children_of(pair: u32) -> Children {
    let first = fetch(tables.pairs + 2u * pair);
    let second = fetch(tables.pairs + 2u * pair + 1u);
    let x = axis_planes(first.x, first.y);
    let y = axis_planes(first.z, first.w);
    let z = axis_planes(second.x, second.y);
    return Children(
        vec3<f32>(x.x, y.x, z.x),
        vec3<f32>(x.y, y.y, z.y),
        vec3<f32>(x.z, y.z, z.z),
        vec3<f32>(x.w, y.w, z.w),
        second.z,
        second.w,
    );
}

// Tests a leaf's primitives, which are of one kind, and says whether it came to
// the end: a driver may stop a loop.
fn test_leaf(probe: Probe, leaf: u32, hit: ptr<function, Hit>) -> bool {
    let kind = (leaf >> LEAF_KIND) & 3u;
    let row = leaf & ((1u << LEAF_COUNT) - 1u);
    let end = row + ((leaf >> LEAF_COUNT) & 7u) + 1u;
    return test_rows(probe, kind, row, end, hit) == end;
}

// Whether something in the box may be nearer than the hit, or as near.
fn may_be_nearer(interval: Interval, hit: Hit) -> bool {
    return interval.enter <= interval.exit && real(interval.enter) <= limit_of(hit);
}

// The last of those that wait, or NOWHERE. It may be farther than the hit by now: to
// visit it costs less than to keep where each is entered.
fn next_waiting(stack: ptr<function, array<u32, STACK>>, depth: ptr<function, u32>) -> u32 {
    if *depth == 0u {
        return NOWHERE;
    }
    *depth -= 1u;
    return (*stack)[*depth];
}

// Tests the boxes of a pair's children and tells where to go on: to the one that is met
// and, if both are, to the nearer one while the other waits.
fn visit_pair(
    probe: Probe,
    at: u32,
    stack: ptr<function, array<u32, STACK>>,
    depth: ptr<function, u32>,
    hit: ptr<function, Hit>,
) -> u32 {
    let children = children_of(at);
    let left = clip_to_box(probe.slabs, children.left_low, children.left_high);
    let right = clip_to_box(probe.slabs, children.right_low, children.right_high);
    let to_left = may_be_nearer(left, *hit);
    let to_right = may_be_nearer(right, *hit);
    count_bound(hit, to_left);
    count_bound(hit, to_right);
    let left_first = to_left && (!to_right || left.enter <= right.enter);
    var next = select(children.right, children.left, left_first);
    if to_left && to_right {
        (*stack)[*depth] = select(children.left, children.right, left_first);
        *depth += 1u;
    }
    if !(to_left || to_right) {
        next = next_waiting(stack, depth);
    }
    return next;
}

// The nearest of all primitives: of the planes, which no volume holds, then of those in
// the tree, the nearer child of each pair first.
//
// While there are pairs, pairs; then a leaf: lanes that run together are thus mostly at
// the same. Aila, Laine, "Understanding the Efficiency of Ray Traversal on GPUs", HPG
// 2009, section 3.
fn closest_hit(probe: Probe, hit: ptr<function, Hit>) {
    closest_plane(probe, hit);
    var stack: array<u32, STACK>;
    var depth = 0u;
    var at = 0u;
    var visits = 0u;
    while at != NOWHERE && visits < MOST_VISITS {
        while (at & LEAF) == 0u && visits < MOST_VISITS {
            visits++;
            at = visit_pair(probe, at, &stack, &depth, hit);
        }
        if at != NOWHERE && (at & LEAF) != 0u && test_leaf(probe, at, hit) {
            visits++;
            at = next_waiting(&stack, &depth);
        }
    }
    if at != NOWHERE || depth > 0u {
        (*hit).tests = GIVEN_UP;
    }
}

// Whether anything is met no later than at `limit`: of shadow rays that is all there is
// to know. The first hit ends it. A ray that is given up counts as blocked, and `tests`
// tells.
fn any_hit(probe: Probe, limit: real, hit: ptr<function, Hit>) -> bool {
    (*hit).t = limit;
    closest_plane(probe, hit);
    var stack: array<u32, STACK>;
    var depth = 0u;
    var at = 0u;
    var visits = 0u;
    while at != NOWHERE && (*hit).id == NO_HIT && visits < MOST_VISITS {
        while (at & LEAF) == 0u && visits < MOST_VISITS {
            visits++;
            at = visit_pair(probe, at, &stack, &depth, hit);
        }
        if at != NOWHERE && (at & LEAF) != 0u && test_leaf(probe, at, hit) {
            visits++;
            at = next_waiting(&stack, &depth);
        }
    }
    if (*hit).id != NO_HIT {
        return true;
    }
    if at != NOWHERE || depth > 0u {
        (*hit).tests = GIVEN_UP;
        return true;
    }
    return false;
}

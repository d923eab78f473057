// Axis-aligned boxes, in f32 in every width of the geometry.
//
// A box that holds another one holds the ray's interval there too, with no allowance
// for rounding: each bound is a rounded difference times a rounded reciprocal, and both
// are monotone. See docs/numerics.md.

// Stands for the reciprocal of zero: larger than that of any component that
// matters, and finite, so that 0 times it is 0.
const HUGE: f32 = 1e30;

// Rays that start farther from the camera meet no box: a scene reaches 2e15 at most, and
// boxes would be wider than that.
const FARTHEST: f32 = 1e21;

// The bits of the largest finite number.
const GREATEST_BITS: u32 = 0x7f7fffffu;

// All points from `low` to `high`.
struct Aabb {
    low: vec3<f32>,
    high: vec3<f32>,
}

// What the slab test needs of a ray.
struct Slabs {
    // Where the ray starts, moved up by what boxes are to be wider for it: what low
    // planes are measured from.
    above: vec3<f32>,
    // The same, moved down.
    below: vec3<f32>,
    // One over each component of its direction.
    inverse: vec3<f32>,
}

// The values of t between which a ray is in a box; none if `enter` > `exit`.
struct Interval {
    enter: f32,
    exit: f32,
}

// 1 / component, but finite.
fn reciprocal(component: f32) -> f32 {
    if abs(component) < 1.0 / HUGE {
        return select(HUGE, -HUGE, component < 0.0);
    }
    return divide_f32(1.0, component);
}

// Whether rays of such a length, from so far away, can be traced: no number of theirs is
// infinite or none at all, and the length is not 0. Told by the bits, since WGSL lets a
// compiler take it that there are no such numbers.
fn leads_somewhere(distance: f32, length: f32) -> bool {
    let near = bitcast<u32>(distance) <= bitcast<u32>(FARTHEST);
    return near && bitcast<u32>(length) - 1u < GREATEST_BITS;
}

// The slabs of a ray that leads nowhere: all boxes are behind it.
fn slabs_of_nothing() -> Slabs {
    let past_all = vec3<f32>(FARTHEST, FARTHEST, FARTHEST);
    return Slabs(past_all, past_all, vec3<f32>(1.0, 1.0, 1.0));
}

// The ray's slabs. Boxes are padded for rays from the camera; for one that starts
// elsewhere they are wider by as much of its origin's distance.
fn slabs_of(ray: Ray) -> Slabs {
    let d = vec3<f32>(ray.direction);
    let o = vec3<f32>(ray.origin);
    let distance = (abs(o.x) + abs(o.y)) + abs(o.z);
    if !leads_somewhere(distance, (abs(d.x) + abs(d.y)) + abs(d.z)) {
        return slabs_of_nothing();
    }
    let margin = distance * padding();
    let wider = vec3<f32>(margin, margin, margin);
    let inverse = vec3<f32>(reciprocal(d.x), reciprocal(d.y), reciprocal(d.z));
    return Slabs(o + wider, o - wider, inverse);
}

// The smaller of two numbers.
fn least(a: f32, b: f32) -> f32 {
    return select(b, a, a < b);
}

// The larger of two numbers.
fn greatest(a: f32, b: f32) -> f32 {
    return select(b, a, a > b);
}

// Where the ray is in the box, after t = 0.
fn clip_to_box(slabs: Slabs, low: vec3<f32>, high: vec3<f32>) -> Interval {
    let to_low = (low - slabs.above) * slabs.inverse;
    let to_high = (high - slabs.below) * slabs.inverse;
    let enter_xy = greatest(least(to_low.x, to_high.x), least(to_low.y, to_high.y));
    let exit_xy = least(greatest(to_low.x, to_high.x), greatest(to_low.y, to_high.y));
    let enter = greatest(enter_xy, least(to_low.z, to_high.z));
    let exit = least(exit_xy, greatest(to_low.z, to_high.z));
    return Interval(greatest(enter, 0.0), exit * slack());
}

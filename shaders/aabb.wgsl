// Axis-aligned boxes, in f32 in every width of the geometry.
//
// A hit counts only where the ray also meets the shape's own box, and its t is
// clamped to the ray's interval there. A box that holds the shape's box holds
// the interval too, with no allowance for rounding: each bound is a rounded
// difference times a rounded reciprocal, and both are monotone. So no volume
// can lose a hit, see docs/numerics.md.

// A box's padding in parts of its shape's distance from the camera: above the
// error with which any shape test accepts a ray, which is at most 16 roundings
// of 2^-24 of that distance.
const PADDING: f32 = 32.0 / 16777216.0;

// By how much an interval's end is moved out: above the three roundings of 2^-24
// of a slab test. Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013.
const SLACK: f32 = 1.0000005;

// Stands for the reciprocal of zero: larger than that of any component that
// matters, and finite, so that 0 times it is 0.
const HUGE: f32 = 1e30;

// All points from `low` to `high`.
struct Aabb {
    low: vec3<f32>,
    high: vec3<f32>,
}

// What the slab test needs of a ray: where it starts, and one over each
// component of its direction.
struct Slabs {
    origin: vec3<f32>,
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
        return copy_sign(HUGE, component);
    }
    return divide(1.0, component);
}

// The ray's slabs.
fn slabs_of(ray: Ray) -> Slabs {
    let d = vec3<f32>(ray.direction);
    let inverse = vec3<f32>(reciprocal(d.x), reciprocal(d.y), reciprocal(d.z));
    return Slabs(vec3<f32>(ray.origin), inverse);
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
    let to_low = (low - slabs.origin) * slabs.inverse;
    let to_high = (high - slabs.origin) * slabs.inverse;
    let enter_xy = greatest(least(to_low.x, to_high.x), least(to_low.y, to_high.y));
    let exit_xy = least(greatest(to_low.x, to_high.x), greatest(to_low.y, to_high.y));
    let enter = greatest(enter_xy, least(to_low.z, to_high.z));
    let exit = least(exit_xy, greatest(to_low.z, to_high.z));
    return Interval(greatest(enter, 0.0), exit * SLACK);
}

// The box from `low` to `high`, padded for a shape whose points lie within
// `reach` of the camera.
fn padded_box(low: vec3<f32>, high: vec3<f32>, reach: f32) -> Aabb {
    let padding = reach * PADDING;
    let pad = vec3<f32>(padding, padding, padding);
    return Aabb(low - pad, high + pad);
}

// The box of the points within `radius` of `center`: of a sphere or a disk.
fn ball_box(center: vec3<f32>, radius: f32) -> Aabb {
    let corner = vec3<f32>(radius, radius, radius);
    let reach = ((abs(center.x) + abs(center.y)) + abs(center.z)) + radius;
    return padded_box(center - corner, center + corner, reach);
}

// The box of a triangle.
fn triangle_box(a: vec3<f32>, b: vec3<f32>, c: vec3<f32>) -> Aabb {
    let low = vec3<f32>(
        least(least(a.x, b.x), c.x),
        least(least(a.y, b.y), c.y),
        least(least(a.z, b.z), c.z),
    );
    let high = vec3<f32>(
        greatest(greatest(a.x, b.x), c.x),
        greatest(greatest(a.y, b.y), c.y),
        greatest(greatest(a.z, b.z), c.z),
    );
    let reach_x = greatest(abs(low.x), abs(high.x));
    let reach_y = greatest(abs(low.y), abs(high.y));
    let reach_z = greatest(abs(low.z), abs(high.z));
    return padded_box(low, high, (reach_x + reach_y) + reach_z);
}

// t, clamped to where the ray is in the shape's own box, or MISS.
fn clamp_to_box(slabs: Slabs, own: Aabb, t: real) -> real {
    let interval = clip_to_box(slabs, own.low, own.high);
    if interval.enter > interval.exit {
        return MISS;
    }
    let enter = real(interval.enter);
    let exit = real(interval.exit);
    if t < enter {
        return enter;
    }
    if t > exit {
        return exit;
    }
    return t;
}

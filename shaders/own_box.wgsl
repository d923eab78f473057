// The box of each shape, a part of its test.
//
// A hit counts only where the ray also meets the shape's own box, and its t is
// clamped to the ray's interval there. So no volume can lose a hit, see
// docs/numerics.md.

// A box's padding in parts of its shape's distance from the camera: above the
// error with which any shape test accepts a ray, which is at most 16 roundings
// of 2^-24 of that distance.
const PADDING: f32 = 32.0 / 16777216.0;

// By how much an interval's end is moved out: above the three roundings of 2^-24
// of a slab test. Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013.
const SLACK: f32 = 1.0000005;

// A box's padding in parts of its shape's distance.
fn padding() -> f32 {
    return PADDING;
}

// By how much an interval's end is moved out.
fn slack() -> f32 {
    return SLACK;
}

// The box from `low` to `high`, padded for a shape whose points lie within
// `reach` of the camera.
fn padded_box(low: vec3<f32>, high: vec3<f32>, reach: f32) -> Aabb {
    let padding = reach * padding();
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

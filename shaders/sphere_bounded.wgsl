// Where a ray meets a sphere, and how far that may be off. The formulas are those of
// sphere.wgsl; the bounds are derived in docs/numerics.md.

// The error of |f|^2, in parts of it: three roundings, and two of the centre's.
const SQUARE_ERROR: f32 = 5.25 / 16777216.0;

// The error of r^2, in parts of it: one rounding, and two of the radius's.
const RADIUS_ERROR: f32 = 3.25 / 16777216.0;

// Where the ray meets the sphere, within bounds, wherever that is.
fn bound_sphere(probe: Probe, sphere: Sphere) -> Meeting {
    let f = probe.ray.origin - sphere.center;
    let d = probe.ray.direction;
    let a = dot_product(d, d);
    let b = -dot_product(f, d);
    let l = f + d * divide(b, a);
    let discriminant = sphere.radius * sphere.radius - dot_product(l, l);

    // By how much l and the radius may be off, and by that the discriminant.
    let reach = (taxicab_length(sphere.center) + taxicab_length(probe.ray.origin)) + sphere.radius;
    let error = reach * ERROR;
    let slack = (2.0 * sphere.radius + error) * error;
    if discriminant < -slack {
        return certain_meeting(MISS);
    }
    let b_error = taxicab_length(d) * error;
    if discriminant <= slack {
        let half = square_root((2.0 * slack) * a) + b_error;
        if b + half < 0.0 {
            return certain_meeting(MISS);
        }
        return doubtful_meeting(divide(b - half, a));
    }

    let root = square_root(a * discriminant);
    let q = b + copy_sign(root, b);
    let q_error = b_error + divide(a * slack, root);
    if q_error * 4.0 > abs(q) {
        return doubtful_meeting(0.0);
    }
    let square = dot_product(f, f);
    let radius_square = sphere.radius * sphere.radius;
    let c = square - radius_square;
    let c_error = (square * SQUARE_ERROR + radius_square * RADIUS_ERROR)
        + (taxicab_length(probe.ray.origin) * taxicab_length(f)) * ERROR;
    let t0 = divide(c, q);
    let t1 = divide(q, a);
    let t0_error = divide(c_error + abs(t0) * q_error, abs(q) - q_error);
    let t1_error = divide(q_error, a);
    let swapped = t1 < t0;
    let near = select(t0, t1, swapped);
    let near_error = select(t0_error, t1_error, swapped);
    let far = select(t1, t0, swapped);
    let far_error = select(t1_error, t0_error, swapped);
    if near + near_error < 0.0 {
        return meeting_within(far, far_error + abs(far) * ERROR);
    }
    return meeting_within(near, near_error + abs(near) * ERROR);
}

// Where the ray meets the sphere within the sphere's own box, within bounds.
fn meet_sphere(probe: Probe, sphere: Sphere) -> Meeting {
    let meeting = bound_sphere(probe, sphere);
    if meeting.low >= MISS {
        return meeting;
    }
    let own = ball_box(vec3<f32>(sphere.center), f32(sphere.radius));
    return meeting_in_box(probe.slabs, own, meeting);
}

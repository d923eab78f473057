// Where a ray meets a sphere, and how far that may be off. The formulas are those of
// sphere.wgsl; the bounds are derived in docs/numerics.md.

// The error of |f|^2, in parts of it: three roundings, and twice one of the centre's and
// one of f's.
const SQUARE_ERROR: f32 = 7.25 / 16777216.0;

// The error of r^2, in parts of it: one rounding, and two of the radius's.
const RADIUS_ERROR: f32 = 3.25 / 16777216.0;

// The error of b and of the power of a sphere that the camera is near, in parts of the
// lengths that they are made of: at most 12 roundings, 8 of them the direction's.
const NEAR_ERROR: f32 = 16.0 / 16777216.0;

// Where the ray meets the sphere, within bounds, wherever that is.
fn bound_sphere(probe: Probe, sphere: Sphere) -> Meeting {
    let origin = probe.ray.origin;
    let f = origin - sphere.center;
    let d = probe.ray.direction;
    let a = dot_product(d, d);
    let b = -dot_product(f, d);
    let distance = taxicab_length(sphere.center) + taxicab_length(origin);

    // By how much l and the radius may be off, and by that a times the discriminant.
    let l = f + d * divide(b, a);
    let error = (distance + sphere.radius) * ERROR;
    let square = dot_product(f, f);
    let radius_square = sphere.radius * sphere.radius;
    var chord = a * (radius_square - dot_product(l, l));
    var slack = a * ((2.0 * sphere.radius + error) * error);
    var b_error = taxicab_length(d) * error;
    let c = sphere_power(origin, sphere);
    var c_error = (square * SQUARE_ERROR + radius_square * RADIUS_ERROR)
        + (taxicab_length(origin) * distance) * ERROR;
    if is_near(sphere) {
        c_error = (abs(c) + taxicab_length(origin) * distance) * NEAR_ERROR;
    }
    if starts_near(sphere, c) {
        b_error = (taxicab_length(d) * distance) * NEAR_ERROR;
        chord = b * b - a * c;
        slack = ((2.0 * abs(b) + b_error) * b_error + a * c_error)
            + (abs(a * c) + b * b) * ERROR;
    }
    if chord < -slack {
        return certain_meeting(MISS);
    }
    if chord <= slack {
        let half = square_root(2.0 * slack) + b_error;
        if b + half < 0.0 {
            return certain_meeting(MISS);
        }
        return doubtful_meeting(divide(b - half, a));
    }

    let root = square_root(chord);
    let q = b + copy_sign(root, b);
    let q_error = b_error + divide(slack, root);
    if q_error * 4.0 > abs(q) {
        return doubtful_meeting(0.0);
    }
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

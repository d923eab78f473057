// Where a ray meets a triangle, and how far that may be off. The formulas are those of
// triangle.wgsl; the bounds are derived in docs/numerics.md.

// The error of a sheared corner, in parts of how far the corners are and how far the ray's
// start is from the camera: at most 27 roundings, 21 of them of the shear.
const TRIANGLE_ERROR: f32 = 30.0 / 16777216.0;

// The smallest of three numbers.
fn least_of(a: real, b: real, c: real) -> real {
    let ab = select(b, a, a < b);
    return select(c, ab, ab < c);
}

// The largest of three numbers.
fn greatest_of(a: real, b: real, c: real) -> real {
    let ab = select(b, a, a > b);
    return select(c, ab, ab > c);
}

// Where the ray meets the triangle, within bounds, wherever that is.
fn bound_triangle(probe: Probe, triangle: Triangle) -> Meeting {
    let origin = probe.ray.origin;
    let shear = probe.shear;
    let a = axis_last(triangle.a - origin, shear.axis);
    let b = axis_last(triangle.b - origin, shear.axis);
    let c = axis_last(triangle.c - origin, shear.axis);
    let ax = a.x - shear.x * a.z;
    let ay = a.y - shear.y * a.z;
    let bx = b.x - shear.x * b.z;
    let by = b.y - shear.y * b.z;
    let cx = c.x - shear.x * c.z;
    let cy = c.y - shear.y * c.z;
    let u = cx * by - cy * bx;
    let v = ax * cy - ay * cx;
    let w = bx * ay - by * ax;

    // By how much the sheared corners may be off, and by that the edge functions.
    let farthest = greatest_of(taxicab_length(a), taxicab_length(b), taxicab_length(c));
    let error = (farthest + 2.0 * taxicab_length(origin)) * TRIANGLE_ERROR;
    let twice = 2.0 * error;
    let a_size = abs(ax) + abs(ay);
    let b_size = abs(bx) + abs(by);
    let c_size = abs(cx) + abs(cy);
    let u_slack = ((b_size + c_size) + twice) * error;
    let v_slack = ((c_size + a_size) + twice) * error;
    let w_slack = ((a_size + b_size) + twice) * error;
    let negative = u < -u_slack || v < -v_slack || w < -w_slack;
    let positive = u > u_slack || v > v_slack || w > w_slack;
    if negative && positive {
        return certain_meeting(MISS);
    }

    // The corners along the ray, in whose range any hit lies.
    let forward = shear.z > 0.0;
    let size = abs(shear.z);
    let near_corner = least_of(a.z, b.z, c.z);
    let far_corner = greatest_of(a.z, b.z, c.z);
    let first = select(-far_corner, near_corner, forward);
    let last = select(-near_corner, far_corner, forward);
    if last + error < 0.0 {
        return certain_meeting(MISS);
    }
    let all_negative = u < -u_slack && v < -v_slack && w < -w_slack;
    let all_positive = u > u_slack && v > v_slack && w > w_slack;
    if !(all_negative || all_positive) {
        return doubtful_meeting(divide(first - error, size));
    }
    let determinant = (u + v) + w;
    let seen = Seen(
        vec3<real>(ax, bx, cx),
        vec3<real>(ay, by, cy),
        vec3<real>(a.z, b.z, c.z),
    );
    let t = divide(depth_between(seen), shear.z);
    let weight_error = divide(((u_slack + v_slack) + w_slack) * 2.0, abs(determinant));
    let in_range = select(last - first, (last - first) * weight_error, weight_error < 1.0);
    return meeting_within(t, divide(in_range + error, size));
}

// Where the ray meets the triangle within the triangle's own box, within bounds.
fn meet_triangle(probe: Probe, triangle: Triangle) -> Meeting {
    let meeting = bound_triangle(probe, triangle);
    if meeting.low >= MISS {
        return meeting;
    }
    let own = triangle_box(vec3<f32>(triangle.a), vec3<f32>(triangle.b), vec3<f32>(triangle.c));
    return meeting_in_box(probe.slabs, own, meeting);
}

//! Where a ray meets a triangle, and how far that may be off. The formulas are those of
//! [`super::triangle`]; the bounds are derived in `docs/numerics.md`.

use super::divide::divide;
use super::doubt::{certain_meeting, doubtful_meeting, meeting_in_box, meeting_within};
use super::hit::Meeting;
use super::own_box::triangle_box;
use super::probe::Probe;
use super::real::{Real, constant};
use super::triangle::{Seen, axis_last, depth_between};
use super::vector::{Vec3, taxicab_length, vec3};
use crate::layout::Triangle;

/// The error of a sheared corner, in parts of how far the corners are and how far the ray's
/// start is from the camera: at most 27 roundings, 21 of them of the shear.
pub const TRIANGLE_ERROR: f32 = 30.0 / 16_777_216.0;

/// The smallest of three numbers.
fn least_of<R: Real>(a: R, b: R, c: R) -> R {
    let ab = if a < b { a } else { b };
    if ab < c { ab } else { c }
}

/// The largest of three numbers.
fn greatest_of<R: Real>(a: R, b: R, c: R) -> R {
    let ab = if a > b { a } else { b };
    if ab > c { ab } else { c }
}

/// Where the ray meets the triangle, within bounds, wherever that is.
#[inline]
fn bound_triangle<R: Real>(probe: Probe<R>, triangle: &Triangle<R>) -> Meeting<R> {
    let origin = probe.ray.origin;
    let shear = probe.shear;
    let a = axis_last(Vec3::from(triangle.a) - origin, shear.axis);
    let b = axis_last(Vec3::from(triangle.b) - origin, shear.axis);
    let c = axis_last(Vec3::from(triangle.c) - origin, shear.axis);
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
    let error = (farthest + R::TWO * taxicab_length(origin)) * constant(TRIANGLE_ERROR);
    let twice = R::TWO * error;
    let a_size = ax.abs() + ay.abs();
    let b_size = bx.abs() + by.abs();
    let c_size = cx.abs() + cy.abs();
    let u_slack = ((b_size + c_size) + twice) * error;
    let v_slack = ((c_size + a_size) + twice) * error;
    let w_slack = ((a_size + b_size) + twice) * error;
    let negative = u < -u_slack || v < -v_slack || w < -w_slack;
    let positive = u > u_slack || v > v_slack || w > w_slack;
    if negative && positive {
        return certain_meeting(R::MISS);
    }

    // The corners along the ray, in whose range any hit lies.
    let forward = shear.z > R::ZERO;
    let size = shear.z.abs();
    let near_corner = least_of(a.z, b.z, c.z);
    let far_corner = greatest_of(a.z, b.z, c.z);
    let first = if forward { near_corner } else { -far_corner };
    let last = if forward { far_corner } else { -near_corner };
    if last + error < R::ZERO {
        return certain_meeting(R::MISS);
    }
    let all_negative = u < -u_slack && v < -v_slack && w < -w_slack;
    let all_positive = u > u_slack && v > v_slack && w > w_slack;
    if !(all_negative || all_positive) {
        return doubtful_meeting(divide(first - error, size));
    }
    let determinant = (u + v) + w;
    let seen = Seen {
        x: vec3(ax, bx, cx),
        y: vec3(ay, by, cy),
        along: vec3(a.z, b.z, c.z),
    };
    let t = divide(depth_between(seen), shear.z);
    let weight_error = divide(((u_slack + v_slack) + w_slack) * R::TWO, determinant.abs());
    let in_range = if weight_error < constant(1.0) {
        (last - first) * weight_error
    } else {
        last - first
    };
    meeting_within(t, divide(in_range + error, size))
}

/// Where the ray meets the triangle within the triangle's own box, within bounds.
#[inline]
pub fn meet_triangle<R: Real>(probe: Probe<R>, triangle: &Triangle<R>) -> Meeting<R> {
    let meeting = bound_triangle(probe, triangle);
    if meeting.low >= R::MISS {
        return meeting;
    }
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| Vec3::from(corner).to_f32());
    let own = triangle_box::<R>(a, b, c);
    meeting_in_box(probe.slabs, own, meeting)
}

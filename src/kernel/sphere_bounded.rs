//! Where a ray meets a sphere, and how far that may be off. The formulas are those of
//! [`super::sphere`]; the bounds are derived in `docs/numerics.md`.

use super::divide::{divide, square_root};
use super::doubt::{ERROR, certain_meeting, doubtful_meeting, meeting_in_box, meeting_within};
use super::hit::Meeting;
use super::own_box::ball_box;
use super::probe::Probe;
use super::real::{Real, constant, copy_sign};
use super::vector::{Vec3, dot_product, taxicab_length};
use crate::layout::Sphere;

/// The error of |f|^2, in parts of it: three roundings, and two of the centre's.
pub const SQUARE_ERROR: f32 = 5.25 / 16_777_216.0;

/// The error of r^2, in parts of it: one rounding, and two of the radius's.
pub const RADIUS_ERROR: f32 = 3.25 / 16_777_216.0;

/// Where the ray meets the sphere, within bounds, wherever that is.
#[inline]
fn bound_sphere<R: Real>(probe: Probe<R>, sphere: &Sphere<R>) -> Meeting<R> {
    let center = Vec3::from(sphere.center);
    let f = probe.ray.origin - center;
    let d = probe.ray.direction;
    let a = dot_product(d, d);
    let b = -dot_product(f, d);
    let l = f + d * divide(b, a);
    let discriminant = sphere.radius * sphere.radius - dot_product(l, l);

    // By how much l and the radius may be off, and by that the discriminant.
    let reach = (taxicab_length(center) + taxicab_length(probe.ray.origin)) + sphere.radius;
    let error = reach * constant(ERROR);
    let slack = (R::TWO * sphere.radius + error) * error;
    if discriminant < -slack {
        return certain_meeting(R::MISS);
    }
    let b_error = taxicab_length(d) * error;
    if discriminant <= slack {
        let half = square_root((R::TWO * slack) * a) + b_error;
        if b + half < R::ZERO {
            return certain_meeting(R::MISS);
        }
        return doubtful_meeting(divide(b - half, a));
    }

    let root = square_root(a * discriminant);
    let q = b + copy_sign(root, b);
    let q_error = b_error + divide(a * slack, root);
    if q_error * constant(4.0) > q.abs() {
        return doubtful_meeting(R::ZERO);
    }
    let square = dot_product(f, f);
    let radius_square = sphere.radius * sphere.radius;
    let c = square - radius_square;
    let c_error = (square * constant(SQUARE_ERROR) + radius_square * constant(RADIUS_ERROR))
        + (taxicab_length(probe.ray.origin) * taxicab_length(f)) * constant(ERROR);
    let t0 = divide(c, q);
    let t1 = divide(q, a);
    let t0_error = divide(c_error + t0.abs() * q_error, q.abs() - q_error);
    let t1_error = divide(q_error, a);
    let swapped = t1 < t0;
    let near = if swapped { t1 } else { t0 };
    let near_error = if swapped { t1_error } else { t0_error };
    let far = if swapped { t0 } else { t1 };
    let far_error = if swapped { t0_error } else { t1_error };
    if near + near_error < R::ZERO {
        return meeting_within(far, far_error + far.abs() * constant(ERROR));
    }
    meeting_within(near, near_error + near.abs() * constant(ERROR))
}

/// Where the ray meets the sphere within the sphere's own box, within bounds.
#[inline]
pub fn meet_sphere<R: Real>(probe: Probe<R>, sphere: &Sphere<R>) -> Meeting<R> {
    let meeting = bound_sphere(probe, sphere);
    if meeting.low >= R::MISS {
        return meeting;
    }
    let center = Vec3::from(sphere.center).to_f32();
    let own = ball_box::<R>(center, sphere.radius.to_f32());
    meeting_in_box(probe.slabs, own, meeting)
}

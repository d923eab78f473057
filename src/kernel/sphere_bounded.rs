//! Where a ray meets a sphere, and how far that may be off. The formulas are those of
//! [`super::sphere`]; the bounds are derived in `docs/numerics.md`.

use super::divide::{divide, square_root};
use super::doubt::{ERROR, certain_meeting, doubtful_meeting, meeting_in_box, meeting_within};
use super::hit::Meeting;
use super::near_spheres::{is_near, sphere_power, starts_near};
use super::own_box::ball_box;
use super::probe::Probe;
use super::real::{Real, constant, copy_sign};
use super::vector::{Vec3, dot_product, taxicab_length};
use crate::layout::Sphere;

/// The error of |f|^2, in parts of it: three roundings, and twice one of the centre's and
/// one of f's.
pub const SQUARE_ERROR: f32 = 7.25 / 16_777_216.0;

/// The error of r^2, in parts of it: one rounding, and two of the radius's.
pub const RADIUS_ERROR: f32 = 3.25 / 16_777_216.0;

/// The error of b and of the power of a sphere that the camera is near, in parts of the
/// lengths that they are made of: at most 12 roundings, 8 of them the direction's.
pub const NEAR_ERROR: f32 = 16.0 / 16_777_216.0;

/// Where the ray meets the sphere, within bounds, wherever that is.
#[inline]
fn bound_sphere<R: Real>(probe: Probe<R>, sphere: &Sphere<R>) -> Meeting<R> {
    let center = Vec3::from(sphere.center);
    let origin = probe.ray.origin;
    let f = origin - center;
    let d = probe.ray.direction;
    let a = dot_product(d, d);
    let b = -dot_product(f, d);
    let distance = taxicab_length(center) + taxicab_length(origin);

    // By how much l and the radius may be off, and by that a times the discriminant.
    let l = f + d * divide(b, a);
    let error = (distance + sphere.radius) * constant(ERROR);
    let square = dot_product(f, f);
    let radius_square = sphere.radius * sphere.radius;
    let mut chord = a * (radius_square - dot_product(l, l));
    let mut slack = a * ((R::TWO * sphere.radius + error) * error);
    let mut b_error = taxicab_length(d) * error;
    let c = sphere_power(origin, sphere);
    let mut c_error = (square * constant(SQUARE_ERROR) + radius_square * constant(RADIUS_ERROR))
        + (taxicab_length(origin) * distance) * constant(ERROR);
    if is_near(sphere) {
        c_error = (c.abs() + taxicab_length(origin) * distance) * constant(NEAR_ERROR);
    }
    if starts_near(sphere, c) {
        b_error = (taxicab_length(d) * distance) * constant(NEAR_ERROR);
        chord = b * b - a * c;
        slack = ((R::TWO * b.abs() + b_error) * b_error + a * c_error)
            + ((a * c).abs() + b * b) * constant(ERROR);
    }
    if chord < -slack {
        return certain_meeting(R::MISS);
    }
    if chord <= slack {
        let half = square_root(R::TWO * slack) + b_error;
        if b + half < R::ZERO {
            return certain_meeting(R::MISS);
        }
        return doubtful_meeting(divide(b - half, a));
    }

    let root = square_root(chord);
    let q = b + copy_sign(root, b);
    let q_error = b_error + divide(slack, root);
    if q_error * constant(4.0) > q.abs() {
        return doubtful_meeting(R::ZERO);
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::camera::Ray;
    use crate::kernel::probe::probe_of;
    use crate::kernel::sphere::intersect_sphere;
    use crate::tier::Bounded;

    fn ray_and_sphere<R: Real>(
        origin: [f64; 3],
        center: [f64; 3],
        radius: f64,
    ) -> (Ray<R>, Sphere<R>) {
        let vector = |v: [f64; 3]| v.map(R::from_f64);
        let ray = Ray {
            origin: Vec3::from(vector(origin)),
            direction: Vec3::from(vector([1.0, 0.0, 0.0])),
        };
        (ray, Sphere::new(vector(center), R::from_f64(radius)))
    }

    /// Nearly all roundings of |f|^2 and r^2 go as far as they can, and none of f's is that
    /// of zero minus the centre: |f|^2 - r^2 is off by 10 u.
    #[test]
    fn a_ray_that_starts_next_to_the_surface_is_in_doubt() {
        let ulp = f64::from(f32::EPSILON);
        let y = 2.0_f64.powi(-12);
        let origin = [-0.5 * ulp * (1.0 + ulp), 0.0, 0.0];
        let center = [1.0 + 2047.5 * ulp, y, y * (1.0 + ulp)];
        let radius = 1.0 + 2048.5 * ulp;
        let (ray, sphere) = ray_and_sphere::<f64>(origin, center, radius);
        let far = intersect_sphere(ray, &sphere);
        assert!(far > 2.0, "inside, by a rounding of f32: {far}");
        let (ray, sphere) = ray_and_sphere::<Bounded>(origin, center, radius);
        let meeting = meet_sphere(probe_of(ray), &sphere);
        assert!(f64::from(meeting.low.0) <= far && far <= f64::from(meeting.high.0));
    }
}

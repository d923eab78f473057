//! Where a ray meets a sphere, within the sphere's own box.

use super::doubt::certain_meeting;
use super::hit::Meeting;
use super::own_box::{ball_box, clamp_to_box};
use super::probe::Probe;
use super::real::Real;
use super::vector::Vec3;
use super::{sphere, sphere_textbook};
use crate::layout::Sphere;
use crate::tier::Formulas;

/// Where the ray meets the sphere.
#[inline]
pub fn meet_sphere<R: Real>(probe: Probe<R>, sphere: &Sphere<R>) -> Meeting<R> {
    let t = match R::FORMULAS {
        Formulas::Textbook => sphere_textbook::intersect_sphere(probe.ray, sphere),
        _ => sphere::intersect_sphere(probe.ray, sphere),
    };
    if t < R::MISS {
        let center = Vec3::from(sphere.center).to_f32();
        let own = ball_box::<R>(center, sphere.radius.to_f32());
        return certain_meeting(clamp_to_box(probe.slabs, own, t));
    }
    certain_meeting(R::MISS)
}

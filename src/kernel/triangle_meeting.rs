//! Where a ray meets a triangle, within the triangle's own box.

use super::doubt::certain_meeting;
use super::hit::Meeting;
use super::own_box::{clamp_to_box, triangle_box};
use super::probe::Probe;
use super::real::Real;
use super::vector::Vec3;
use super::{triangle, triangle_textbook};
use crate::layout::Triangle;
use crate::tier::Formulas;

/// Where the ray meets the triangle.
#[inline]
pub fn meet_triangle<R: Real>(probe: Probe<R>, triangle: &Triangle<R>) -> Meeting<R> {
    let t = match R::FORMULAS {
        Formulas::Textbook => triangle_textbook::intersect_triangle(probe.ray, triangle),
        _ => triangle::intersect_triangle(probe.ray, probe.shear, triangle),
    };
    if t < R::MISS {
        let [a, b, c] =
            [triangle.a, triangle.b, triangle.c].map(|corner| Vec3::from(corner).to_f32());
        let own = triangle_box::<R>(a, b, c);
        return certain_meeting(clamp_to_box(probe.slabs, own, t));
    }
    certain_meeting(R::MISS)
}

//! Where a ray meets a plane.

use super::doubt::certain_meeting;
use super::hit::Meeting;
use super::probe::Probe;
use super::real::Real;
use super::vector::Vec3;
use super::{plane, plane_textbook};
use crate::layout::Plane;
use crate::tier::Formulas;

/// Where the ray meets the plane.
pub fn meet_plane<R: Real>(probe: Probe<R>, plane: &Plane<R>) -> Meeting<R> {
    let (point, normal) = (Vec3::from(plane.point), Vec3::from(plane.normal));
    certain_meeting(match R::FORMULAS {
        Formulas::Textbook => plane_textbook::intersect_plane(probe.ray, point, normal),
        _ => plane::intersect_plane(probe.ray, point, normal),
    })
}

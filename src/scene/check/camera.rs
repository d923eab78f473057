//! Rules for the camera.

use glam::DVec3;

use super::rule::{Verdict, direction, flaw, not_negative, point, require, size};
use super::solid::reach;
use crate::scene::Camera;

/// Sine of the smallest angle between `up` and the line of sight. Rounding
/// leaves their f64 cross product (differences, products, sums) with a relative
/// error below 3 sqrt(3) 2^-53 over that sine; at 2^-26 the camera's horizontal
/// axis still has the 24 bits of an f32.
const MIN_UP_SINE: f64 = 1.0 / (1u64 << 26) as f64;

/// A camera that looks somewhere and knows what is up.
pub fn camera(camera: &Camera) -> Verdict {
    point("eye", camera.eye)?;
    point("target", camera.target)?;
    direction("up", camera.up)?;
    field_of_view("fov", camera.fov_degrees)?;
    line_of_sight(camera.eye, camera.target)?;
    upward(camera.up, camera.target - camera.eye)?;
    not_negative("aperture", camera.aperture)?;
    camera.focus.map_or(Ok(()), |focus| size("focus", focus))?;
    point("velocity", camera.velocity)?;
    lens_within_reach(camera)
}

/// The lens stays within reach while the shutter is open.
pub fn lens_within_reach(camera: &Camera) -> Verdict {
    let lens = DVec3::splat(camera.aperture / 2.0);
    reach("the camera", camera.eye.abs() + lens, camera.velocity)
}

/// A full angle of view in degrees, between 0 and 180.
pub fn field_of_view(what: &str, degrees: f64) -> Verdict {
    require(degrees > 0.0 && degrees < 180.0, || {
        let message = format!("`{what}` must lie between 0 and 180 degrees, but is {degrees}");
        flaw(message, "out of range", "60 is a usual full vertical angle")
    })
}

/// The camera looks somewhere.
pub fn line_of_sight(eye: DVec3, target: DVec3) -> Verdict {
    require((target - eye).length_squared() >= f64::MIN_POSITIVE, || {
        flaw(
            format!("`target` {target} is where `eye` is: the camera looks nowhere"),
            "same as eye",
            "move `target` to the point in the middle of the picture",
        )
    })
}

/// `up` is not along the line of sight, so the picture has a horizontal.
pub fn upward(up: DVec3, forward: DVec3) -> Verdict {
    let (up_length, forward_length) = (up.length(), forward.length());
    let sine = (up / up_length).cross(forward / forward_length).length();
    require(sine >= MIN_UP_SINE, || {
        flaw(
            format!("`up` {up} is parallel to the line of sight {forward}"),
            "parallel to the line of sight",
            "choose another `up`, such as [0, 0, 1] for a camera that looks straight down",
        )
    })
}

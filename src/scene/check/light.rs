//! Rules for lights.

use glam::DVec3;

use super::rule::{MIN_SIZE, Verdict, color, direction, flaw, point, require, size};
use super::solid::{CANCELLED, reach};
use crate::scene::{AreaForm, Light};

/// Most lights of a scene: a pixel is shaded in one loop over all of them, which
/// lavapipe silently stops after 65,535 iterations.
pub const MAX_LIGHTS: usize = 60_000;

/// No more lights than one loop takes.
pub fn light_count(lights: usize) -> Verdict {
    require(lights <= MAX_LIGHTS, || {
        flaw(
            format!("{lights} lights are more than {MAX_LIGHTS}"),
            "too many",
            format!("keep to {MAX_LIGHTS} lights; one brighter light may stand for several"),
        )
    })
}

/// A light that shines from somewhere.
pub fn light(light: &Light) -> Verdict {
    match *light {
        Light::Point {
            position, color: c, ..
        } => point("position", position).and_then(|()| color("color", c)),
        Light::Directional {
            direction: d,
            color: c,
            ..
        } => direction("direction", d).and_then(|()| color("color", c)),
        Light::Area { form, radiance } => {
            area_form(&form).and_then(|()| color("radiance", radiance))
        }
    }
}

/// A form with an area, within reach.
pub fn area_form(form: &AreaForm) -> Verdict {
    let extent = match *form {
        AreaForm::Sphere { center, radius } => {
            point("center", center)?;
            size("radius", radius)?;
            center.abs() + DVec3::splat(radius)
        }
        AreaForm::Disk {
            center,
            normal,
            radius,
        } => {
            point("center", center)?;
            direction("normal", normal)?;
            size("radius", radius)?;
            center.abs() + DVec3::splat(radius)
        }
        AreaForm::Rectangle { corner, right, up } => {
            point("corner", corner)?;
            edge("right", right)?;
            edge("up", up)?;
            edges(right, up)?;
            corner.abs() + right.abs() + up.abs()
        }
    };
    reach("the light", extent, DVec3::ZERO)
}

/// An edge of a rectangle: as long as a radius has to be.
pub fn edge(what: &str, edge: DVec3) -> Verdict {
    point(what, edge)?;
    require(edge.length() >= MIN_SIZE, || {
        flaw(
            format!("`{what}` is {edge}, shorter than {MIN_SIZE:e}"),
            "too short",
            "write the vector from the corner to the next one",
        )
    })
}

/// Two edges that span an area: their cross product is larger than its own rounding error.
pub fn edges(right: DVec3, up: DVec3) -> Verdict {
    let area = right.cross(up).length();
    require(area > CANCELLED * right.length() * up.length(), || {
        flaw(
            format!("`right` {right} and `up` {up} are parallel: they span no area"),
            "parallel",
            "write two edges that meet at an angle, such as [2, 0, 0] and [0, 1, 0]",
        )
    })
}

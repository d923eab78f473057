//! Rules for what is all around.

use super::material::albedo;
use super::rule::{Verdict, color, not_negative, number, size};
use crate::scene::{Background, Environment, Fog, Rgb, Sky};

/// A ramp between two colours.
pub fn background(background: &Background) -> Verdict {
    ramp("background", background)
}

/// Light from all around, but for the texels of its image.
pub fn environment(environment: &Environment) -> Verdict {
    not_negative("intensity", environment.intensity)?;
    number("turn", environment.turn_degrees)?;
    match &environment.sky {
        Sky::Gradient(gradient) => {
            ramp("environment", gradient)?;
            let intensity = environment.intensity;
            shine(gradient.from, intensity)?;
            shine(gradient.to, intensity)
        }
        Sky::Image(_) => Ok(()),
    }
}

/// A colour times an intensity.
pub fn shine(rgb: Rgb, intensity: f64) -> Verdict {
    color("color times intensity", rgb.map(|c| c * intensity))
}

/// A medium that takes something out of a ray.
pub fn fog(fog: &Fog) -> Verdict {
    size("density", fog.density)?;
    albedo("albedo", fog.albedo)
}

/// How far something has to be not to keep ambient light off; 0 for nothing does.
pub fn occlusion(what: &str, distance: f64) -> Verdict {
    if distance == 0.0 {
        Ok(())
    } else {
        size(what, distance)
    }
}

fn ramp(what: &str, ramp: &Background) -> Verdict {
    color(&format!("{what} from"), ramp.from)?;
    color(&format!("{what} to"), ramp.to)?;
    number(&format!("{what} offset"), ramp.offset)?;
    number(&format!("{what} slope"), ramp.slope)
}

//! `[background]`, `[environment]`, `[fog]` and `[ambient]`.

use super::faults::Faults;
use super::image_file::ImageFiles;
use super::section::Section;
use super::value::{albedo, color, number, ruled};
use crate::scene::{Background, Environment, Fog, Rgb, Sky, check};

const BLACK: Rgb = [0.0; 3];

/// The keys of a ramp between two colours.
const RAMP: [&str; 4] = ["from", "to", "offset", "slope"];

pub(super) fn background(section: Option<Section<'_, '_>>, faults: &mut Faults<'_>) -> Background {
    let plain = Background::plain(BLACK);
    let Some(mut section) = section else {
        return plain;
    };
    if section.has("color") && has_ramp(&section) {
        let message = "[background] has both a plain `color` and a ramp".to_owned();
        let help = "keep `color`, or `from` and `to` with `offset` and `slope`";
        section.reject(faults, message, help);
        return plain;
    }
    let background = gradient(&mut section, faults);
    section.close(faults);
    background
}

pub(super) fn environment(
    section: Option<Section<'_, '_>>,
    images: &mut ImageFiles<'_>,
    faults: &mut Faults<'_>,
) -> Option<Environment> {
    let mut section = section?;
    let given = [
        section.has("file"),
        section.has("color"),
        has_ramp(&section),
    ];
    let count = given.iter().filter(|given| **given).count();
    if count != 1 {
        if count > 1 || faults.is_whole(&section.span) {
            let what = if count > 1 { "more than one" } else { "none" };
            let message = format!("[environment] has {what} of `file`, `color` and a ramp");
            let help = "write exactly one: `file = \"sky.exr\"`, `color`, or `from` and `to`";
            section.reject(faults, message, help);
        }
        return None;
    }
    let intensity = section.or("intensity", 1.0, faults, ruled(number, check::not_negative));
    let turn_degrees = section.or("turn", 0.0, faults, number);
    let sky = if section.has("file") {
        section.know(&["color"]);
        section.know(&RAMP);
        let file = section.value("file")?;
        images.wide_range(file, faults).map(Sky::Image)
    } else {
        section.know(&["file"]);
        Some(Sky::Gradient(gradient(&mut section, faults)))
    };
    let header = section.span.clone();
    section.close(faults);
    let environment = Environment {
        sky: sky?,
        intensity,
        turn_degrees,
    };
    let verdict = check::environment(&environment);
    faults.judge(header, verdict).then_some(environment)
}

pub(super) fn fog(section: Option<Section<'_, '_>>, faults: &mut Faults<'_>) -> Option<Fog> {
    let mut section = section?;
    let density = section.required("density", faults, ruled(number, check::size));
    let albedo = section.or("albedo", [1.0; 3], faults, albedo);
    section.close(faults);
    density.map(|density| Fog {
        density: density.value,
        albedo,
    })
}

/// Ambient light, and how far something has to be not to keep it off.
pub(super) fn ambient(section: Option<Section<'_, '_>>, faults: &mut Faults<'_>) -> (Rgb, f64) {
    let Some(mut section) = section else {
        return (BLACK, 0.0);
    };
    let ambient = section.or("color", BLACK, faults, color);
    let occlusion = section.or("occlusion", 0.0, faults, ruled(number, check::size));
    section.close(faults);
    (ambient, occlusion)
}

fn has_ramp(section: &Section<'_, '_>) -> bool {
    RAMP.iter().any(|key| section.has(key))
}

/// `color`, or the keys of a ramp.
fn gradient(section: &mut Section<'_, '_>, faults: &mut Faults<'_>) -> Background {
    if !has_ramp(section) {
        let background = Background::plain(section.or("color", BLACK, faults, color));
        // Asked for only so that a misspelt key is compared with them too.
        section.know(&RAMP);
        return background;
    }
    let from = section.required("from", faults, color);
    let to = section.required("to", faults, color);
    section.know(&["color"]);
    Background {
        from: from.map_or(BLACK, |found| found.value),
        to: to.map_or(BLACK, |found| found.value),
        offset: section.or("offset", 0.5, faults, number),
        slope: section.or("slope", 0.5, faults, number),
    }
}

//! `[image]`, `[camera]`, `[background]`, `[ambient]` and `[[light]]`.

use super::faults::Faults;
use super::section::Section;
use super::value::{choice, color, number, ruled, vector, whole};
use crate::scene::{
    Background, Camera, Falloff, Image, Light, PixelSampling, Rgb, Transfer, check,
};

const BLACK: Rgb = [0.0; 3];
const WHITE: Rgb = [1.0; 3];

pub(super) fn image(section: Option<Section<'_, '_>>, faults: &mut Faults<'_>) -> Image {
    let mut image = Image {
        width: 640,
        height: 480,
        transfer: Transfer::Srgb,
    };
    let Some(mut section) = section else {
        return image;
    };
    let mut side = |key, default: u32| {
        let pixels = section.or(key, default.into(), faults, whole(check::image_side));
        u32::try_from(pixels).unwrap_or(default)
    };
    image.width = side("width", image.width);
    image.height = side("height", image.height);
    let curves = [
        ("srgb", Transfer::Srgb),
        ("sqrt", Transfer::Sqrt),
        ("linear", Transfer::Linear),
    ];
    image.transfer = section.or("transfer", image.transfer, faults, choice(&curves));
    section.close(faults);
    image
}

pub(super) fn camera(mut section: Section<'_, '_>, faults: &mut Faults<'_>) -> Option<Camera> {
    let eye = section.required("eye", faults, vector);
    let target = section.required("target", faults, vector);
    let up = section.optional("up", faults, ruled(vector, check::direction));
    let up_default = !section.has("up");
    let fov_degrees = section.or("fov", 60.0, faults, ruled(number, check::field_of_view));
    let samplings = [
        ("center", PixelSampling::Center),
        ("corner", PixelSampling::Corner),
    ];
    let sampling = section.or(
        "sampling",
        PixelSampling::Center,
        faults,
        choice(&samplings),
    );
    let header = section.span.clone();
    section.close(faults);

    let (eye, target) = (eye?, target?);
    let forward = target.value - eye.value;
    let looks = faults.judge(target.span, check::line_of_sight(eye.value, target.value));
    let (up, up_span) = match up {
        Some(up) => (up.value, up.span),
        None if up_default => (glam::DVec3::Y, header),
        None => return None,
    };
    let upright = looks && faults.judge(up_span, check::upward(up, forward));
    upright.then_some(Camera {
        eye: eye.value,
        target: target.value,
        up,
        fov_degrees,
        sampling,
        ..Camera::default()
    })
}

pub(super) fn background(section: Option<Section<'_, '_>>, faults: &mut Faults<'_>) -> Background {
    let plain = Background::plain(BLACK);
    let Some(mut section) = section else {
        return plain;
    };
    let ramp = ["from", "to", "offset", "slope"];
    if section.has("color") && ramp.iter().any(|key| section.has(key)) {
        let message = "[background] has both a plain `color` and a ramp".to_owned();
        let help = "keep `color`, or `from` and `to` with `offset` and `slope`";
        section.reject(faults, message, help);
        return plain;
    }
    let background = if ramp.iter().any(|key| section.has(key)) {
        let from = section.required("from", faults, color);
        let to = section.required("to", faults, color);
        Background {
            from: from.map_or(BLACK, |found| found.value),
            to: to.map_or(BLACK, |found| found.value),
            offset: section.or("offset", 0.5, faults, number),
            slope: section.or("slope", 0.5, faults, number),
        }
    } else {
        let background = Background::plain(section.or("color", BLACK, faults, color));
        // Asked for only so that a misspelt key is compared with them too.
        section.know(&ramp);
        background
    };
    section.know(&["color"]);
    section.close(faults);
    background
}

pub(super) fn ambient(section: Option<Section<'_, '_>>, faults: &mut Faults<'_>) -> Rgb {
    let Some(mut section) = section else {
        return BLACK;
    };
    let ambient = section.or("color", BLACK, faults, color);
    section.close(faults);
    ambient
}

/// The keys that one kind of light has.
#[derive(Clone, Copy)]
enum LightKind {
    Point,
    Directional,
}

pub(super) fn light(mut section: Section<'_, '_>, faults: &mut Faults<'_>) -> Option<Light> {
    let kinds = [
        ("point", LightKind::Point),
        ("directional", LightKind::Directional),
    ];
    let falloffs = [
        ("none", Falloff::None),
        ("inverse-square", Falloff::InverseSquare),
    ];
    let kind = section.required("kind", faults, choice(&kinds));
    let tint = section.or("color", WHITE, faults, color);
    let intensity = section.or("intensity", 1.0, faults, ruled(number, check::not_negative));
    let bright = tint.map(|c| c * intensity);
    faults.judge(
        section.span.clone(),
        check::color("color times intensity", bright),
    );
    let light = match kind.map(|found| found.value) {
        Some(LightKind::Point) => {
            let falloff = section.or("falloff", Falloff::None, faults, choice(&falloffs));
            section
                .required("position", faults, vector)
                .map(|position| Light::Point {
                    position: position.value,
                    color: bright,
                    falloff,
                    shadow: false,
                })
        }
        Some(LightKind::Directional) => section
            .required("direction", faults, ruled(vector, check::direction))
            .map(|direction| Light::Directional {
                direction: direction.value,
                color: bright,
                shadow: false,
            }),
        None => {
            // Which keys belong here cannot be said without the kind.
            section.know(&["position", "falloff", "direction"]);
            None
        }
    };
    section.close(faults);
    light
}

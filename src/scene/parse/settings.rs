//! `[image]`, `[camera]` and `[integrator]`.

use super::faults::Faults;
use super::section::Section;
use super::value::{choice, number, ruled, vector, whole};
use crate::scene::{Camera, Image, Integrator, PixelSampling, Strategy, Transfer, check};

pub(super) fn image(section: Option<Section<'_, '_>>, faults: &mut Faults<'_>) -> Image {
    let mut image = Image::default();
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
    let aperture = section.or("aperture", 0.0, faults, ruled(number, check::not_negative));
    let focus = section.optional("focus", faults, ruled(number, check::size));
    let velocity = section.or("velocity", glam::DVec3::ZERO, faults, vector);
    let header = section.span.clone();
    section.close(faults);

    let (eye, target) = (eye?, target?);
    let forward = target.value - eye.value;
    let looks = faults.judge(target.span, check::line_of_sight(eye.value, target.value));
    let (up, up_span) = match up {
        Some(up) => (up.value, up.span),
        None if up_default => (glam::DVec3::Y, header.clone()),
        None => return None,
    };
    let upright = looks && faults.judge(up_span, check::upward(up, forward));
    let camera = Camera {
        eye: eye.value,
        target: target.value,
        up,
        fov_degrees,
        sampling,
        aperture,
        focus: focus.map(|found| found.value),
        velocity,
    };
    let near = faults.judge(header, check::lens_within_reach(&camera));
    (upright && near).then_some(camera)
}

pub(super) fn integrator(section: Option<Section<'_, '_>>, faults: &mut Faults<'_>) -> Integrator {
    let mut integrator = Integrator::default();
    let Some(mut section) = section else {
        return integrator;
    };
    type Rule = fn(&str, u64) -> check::Verdict;
    let mut number = |key, default: u32, rule: Rule| {
        let number = section.or(key, default.into(), faults, whole(rule));
        u32::try_from(number).unwrap_or(default)
    };
    integrator.samples = number("samples", integrator.samples, check::samples);
    integrator.bounces = number("bounces", integrator.bounces, check::events);
    integrator.reflections = number("reflections", integrator.reflections, check::events);
    integrator.seed = number("seed", integrator.seed, check::seed);
    let strategies = [
        ("both", Strategy::Both),
        ("lights", Strategy::Lights),
        ("surfaces", Strategy::Surfaces),
    ];
    integrator.strategy = section.or("strategy", integrator.strategy, faults, choice(&strategies));
    section.close(faults);
    integrator
}

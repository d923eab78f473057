//! `[[light]]`.

use super::faults::Faults;
use super::section::Section;
use super::value::{boolean, choice, color, number, ruled, text, vector};
use crate::scene::{AreaForm, Falloff, Light, Rgb, check};

/// The keys that one kind of light has.
#[derive(Clone, Copy)]
enum Kind {
    Point,
    Directional,
    Sphere,
    Disk,
    Rectangle,
}

/// The keys that only some kinds have.
const OWN_KEYS: [&str; 9] = [
    "position",
    "direction",
    "falloff",
    "shadow",
    "radius",
    "normal",
    "corner",
    "right",
    "up",
];

/// A light and its name.
pub(super) fn light(
    mut section: Section<'_, '_>,
    faults: &mut Faults<'_>,
) -> Option<(Light, Option<String>)> {
    let kinds = [
        ("point", Kind::Point),
        ("directional", Kind::Directional),
        ("sphere", Kind::Sphere),
        ("disk", Kind::Disk),
        ("rectangle", Kind::Rectangle),
    ];
    let kind = section.required("kind", faults, choice(&kinds));
    let name = section.optional("name", faults, text);
    let tint = section.or("color", [1.0; 3], faults, color);
    let intensity = section.or("intensity", 1.0, faults, ruled(number, check::not_negative));
    let bright = tint.map(|c| c * intensity);
    faults.judge(section.span.clone(), check::shine(tint, intensity));
    let light = match kind.map(|found| found.value) {
        Some(Kind::Point) => point(&mut section, bright, faults),
        Some(Kind::Directional) => directional(&mut section, bright, faults),
        Some(Kind::Sphere) => sphere(&mut section, faults).map(area(bright)),
        Some(Kind::Disk) => disk(&mut section, faults).map(area(bright)),
        Some(Kind::Rectangle) => rectangle(&mut section, faults).map(area(bright)),
        None => {
            // Which keys belong here cannot be said without the kind.
            section.know(&OWN_KEYS);
            None
        }
    };
    if let Some(Light::Area { form, .. }) = &light {
        faults.judge(section.span.clone(), check::area_form(form));
    }
    section.close(faults);
    light.map(|light| (light, name.map(|found| found.value)))
}

fn point(section: &mut Section<'_, '_>, color: Rgb, faults: &mut Faults<'_>) -> Option<Light> {
    let falloffs = [
        ("none", Falloff::None),
        ("inverse-square", Falloff::InverseSquare),
    ];
    let falloff = section.or("falloff", Falloff::None, faults, choice(&falloffs));
    let shadow = section.or("shadow", true, faults, boolean);
    let position = section.required("position", faults, vector)?;
    Some(Light::Point {
        position: position.value,
        color,
        falloff,
        shadow,
    })
}

fn directional(
    section: &mut Section<'_, '_>,
    color: Rgb,
    faults: &mut Faults<'_>,
) -> Option<Light> {
    let shadow = section.or("shadow", true, faults, boolean);
    let direction = section.required("direction", faults, ruled(vector, check::direction))?;
    Some(Light::Directional {
        direction: direction.value,
        color,
        shadow,
    })
}

fn sphere(section: &mut Section<'_, '_>, faults: &mut Faults<'_>) -> Option<AreaForm> {
    let center = section.required("position", faults, vector);
    let radius = section.required("radius", faults, ruled(number, check::size));
    Some(AreaForm::Sphere {
        center: center?.value,
        radius: radius?.value,
    })
}

fn disk(section: &mut Section<'_, '_>, faults: &mut Faults<'_>) -> Option<AreaForm> {
    let center = section.required("position", faults, vector);
    let normal = section.required("normal", faults, ruled(vector, check::direction));
    let radius = section.required("radius", faults, ruled(number, check::size));
    Some(AreaForm::Disk {
        center: center?.value,
        normal: normal?.value,
        radius: radius?.value,
    })
}

fn rectangle(section: &mut Section<'_, '_>, faults: &mut Faults<'_>) -> Option<AreaForm> {
    let corner = section.required("corner", faults, vector);
    let right = section.required("right", faults, ruled(vector, check::edge));
    let up = section.required("up", faults, ruled(vector, check::edge));
    let (corner, right, up) = (corner?.value, right?.value, up?);
    let spans = faults.judge(up.span, check::edges(right, up.value));
    spans.then_some(AreaForm::Rectangle {
        corner,
        right,
        up: up.value,
    })
}

fn area(radiance: Rgb) -> impl FnOnce(AreaForm) -> Light {
    move |form| Light::Area { form, radiance }
}

//! The keys of a `[[material]]`, apart from its name.

use toml::de::DeValue;

use super::faults::Faults;
use super::image_file::ImageFiles;
use super::section::Section;
use super::value::{Value, albedo, choice, color, fractions, number, pair, ruled, triple, whole};
use crate::scene::{Material, Pattern, Rgb, Texture, check};

/// The mirror of a surface that is only said to be rough: varnish and most plastics throw
/// back 4 % of the light that comes straight on, as their index of refraction is near 1.5.
const VARNISH: Rgb = [0.04; 3];

/// What can be said of a material without saying its albedo.
const INSTEAD: [&str; 5] = ["mirror", "roughness", "ior", "emission", "texture"];

/// A material without its name.
pub(super) struct Surface {
    pub(super) material: Material,
    /// From what the albedo of every instance is drawn, where it is.
    pub(super) seed: Option<u64>,
}

#[derive(Clone, Copy)]
enum Albedo {
    Plain(Rgb),
    Random(u64),
}

/// Reads the keys. A fault is in the list; the default stands in.
pub(super) fn surface(
    section: &mut Section<'_, '_>,
    images: &mut ImageFiles<'_>,
    faults: &mut Faults<'_>,
) -> Surface {
    let mut material = Material::default();
    let mut seed = None;
    match base(section, faults) {
        Some(Albedo::Plain(albedo)) => material.albedo = albedo,
        Some(Albedo::Random(from)) => seed = Some(from),
        None => {}
    }
    let smooth = !section.has("roughness");
    let plain = if smooth { material.mirror } else { VARNISH };
    material.mirror = section.or("mirror", plain, faults, fractions);
    material.roughness = section.or("roughness", 0.0, faults, ruled(number, check::fraction));
    let ior = section.optional("ior", faults, ruled(number, check::ior));
    material.ior = ior.map(|found| found.value);
    material.absorption = section.or("absorption", [0.0; 3], faults, color);
    material.emission = section.or("emission", [0.0; 3], faults, color);
    material.texture = section
        .value("texture")
        .and_then(|value| texture(value, images, faults));
    let cuts = [("ignore", false), ("cutout", true)];
    material.cutout = section.or("alpha", false, faults, choice(&cuts));
    agree(section, &material, faults);
    Surface { material, seed }
}

/// Do the keys go together?
fn agree(section: &Section<'_, '_>, material: &Material, faults: &mut Faults<'_>) {
    let clear = section.has("ior");
    for key in ["mirror", "roughness", "texture"] {
        if let Some(span) = section.span_of(key) {
            faults.judge(span, check::not_clear(key, clear));
        }
    }
    if !faults.is_whole(&section.span) {
        return;
    }
    if let Some(span) = section.span_of("absorption") {
        faults.judge(span, check::only_clear("absorption", clear));
    }
    let no_image = match &material.texture {
        Some(texture) => matches!(texture.pattern, Pattern::Checker(_)),
        None => !section.has("texture"),
    };
    if let Some(span) = section.span_of("alpha") {
        faults.judge(span, check::cutout(!(material.cutout && no_image)));
    }
}

fn base(section: &mut Section<'_, '_>, faults: &mut Faults<'_>) -> Option<Albedo> {
    match section.value("albedo") {
        Some(value) => match value.get_ref() {
            DeValue::Table(_) => random(value, faults),
            _ => albedo(value, "albedo", faults).map(Albedo::Plain),
        },
        None if INSTEAD.iter().any(|key| section.has(key)) => None,
        // Only to say that it is missing.
        None => section
            .required("albedo", faults, triple(number))
            .map(|found| Albedo::Plain(found.value)),
    }
}

fn random(value: &Value<'_>, faults: &mut Faults<'_>) -> Option<Albedo> {
    let mut section = Section::within("albedo", value, faults)?;
    let seed = section.required("random", faults, whole(|_, _| Ok(())));
    section.close(faults);
    seed.map(|found| Albedo::Random(found.value))
}

fn texture(
    value: &Value<'_>,
    images: &mut ImageFiles<'_>,
    faults: &mut Faults<'_>,
) -> Option<Texture> {
    let mut section = Section::within("texture", value, faults)?;
    let repeat = section.or("repeat", [1.0; 2], faults, pair(ruled(number, check::size)));
    let size = section.or("size", 1.0, faults, ruled(number, check::size));
    let checker = section.value("checker");
    let file = section.value("file");
    let pattern = match (checker, file) {
        (Some(color), None) => albedo(color, "checker", faults).map(Pattern::Checker),
        (None, Some(file)) => images.albedo(file, faults).map(Pattern::Image),
        (both, _) => {
            let (message, label) = match both {
                Some(_) => ("`texture` has both `checker` and `file`", "two patterns"),
                None => ("`texture` has neither `checker` nor `file`", "no pattern"),
            };
            let help = "write exactly one: `checker = [r, g, b]`, or `file = \"wood.png\"`";
            faults.push(value.span(), message, label, help);
            None
        }
    };
    section.close(faults);
    pattern.map(|pattern| Texture {
        pattern,
        repeat,
        size,
    })
}

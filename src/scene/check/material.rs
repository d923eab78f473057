//! Rules for materials, textures and images.

use std::ops::RangeInclusive;

use super::rule::{Flaw, MAX_MAGNITUDE, Verdict, color, flaw, fraction, number, require, size};
use crate::scene::{Material, Pattern, Rgb, Texels, Texture};

/// Indices of refraction: from that of nothing at all to that of germanium, the
/// highest of a common lens.
const IOR: RangeInclusive<f64> = 1.0..=4.0;

/// A surface that gives back no more light than it gets, besides what it shines itself.
pub fn material(material: &Material) -> Verdict {
    albedo("albedo", material.albedo)?;
    let clear = material.ior.is_some();
    mirror("mirror", material.mirror)?;
    not_clear("mirror", clear && material.mirror != [0.0; 3])?;
    fraction("roughness", material.roughness)?;
    not_clear("roughness", clear && material.roughness != 0.0)?;
    material.ior.map_or(Ok(()), |index| ior("ior", index))?;
    color("absorption", material.absorption)?;
    only_clear("absorption", clear || material.absorption == [0.0; 3])?;
    color("emission", material.emission)?;
    not_clear("texture", clear && material.texture.is_some())?;
    material.texture.as_ref().map_or(Ok(()), texture)?;
    let image = material.texture.as_ref().map(|texture| &texture.pattern);
    cutout(!material.cutout || matches!(image, Some(Pattern::Image(_))))
}

/// A fraction of light per channel.
pub fn albedo(what: &str, rgb: Rgb) -> Verdict {
    rgb.iter().try_for_each(|&x| {
        number(what, x)?;
        require((0.0..=1.0).contains(&x), || {
            let message = format!("`{what}` must lie between 0 and 1, but has a part of {x}");
            let help = "a surface scatters no less than none and no more than all of the light";
            flaw(message, "out of range", help)
        })
    })
}

/// A fraction of light per channel that a mirror throws back.
pub fn mirror(what: &str, rgb: Rgb) -> Verdict {
    rgb.iter().try_for_each(|&x| fraction(what, x))
}

/// An index of refraction.
pub fn ior(what: &str, index: f64) -> Verdict {
    require(IOR.contains(&index), || {
        let (least, most) = (IOR.start(), IOR.end());
        let message = format!("`{what}` must be from {least} to {most}, but is {index}");
        let help = "water has 1.33, window glass 1.52, diamond 2.42";
        flaw(message, "out of range", help)
    })
}

/// What a clear body does not have; `both` where it has it nevertheless.
pub fn not_clear(what: &str, both: bool) -> Verdict {
    require(!both, || {
        flaw(
            format!(
                "`{what}` goes without `ior`: a clear body is smooth and without a colour at its \
                 surface, and mirrors as `ior` says"
            ),
            "of no use with `ior`",
            format!("remove `{what}`, or remove `ior` where the body is not clear"),
        )
    })
}

/// What only a clear body has; not `fits` where another has it.
pub fn only_clear(what: &str, fits: bool) -> Verdict {
    require(fits, || {
        flaw(
            format!("`{what}` goes with `ior`: light passes through clear bodies alone"),
            "of no use without `ior`",
            format!("add `ior = 1.5`, or remove `{what}`"),
        )
    })
}

/// Holes come from an image; not `fits` where there is none.
pub fn cutout(fits: bool) -> Verdict {
    require(fits, || {
        flaw(
            "`alpha = \"cutout\"` goes with a texture from a file: its alpha says where the holes are"
                .into(),
            "no image",
            "add `texture = { file = \"leaf.png\" }`, or remove `alpha`",
        )
    })
}

/// A texture, but for the texels of its image.
pub fn texture(texture: &Texture) -> Verdict {
    if let Pattern::Checker(rgb) = texture.pattern {
        albedo("checker", rgb)?;
    }
    texture.repeat.iter().try_for_each(|&x| size("repeat", x))?;
    size("size", texture.size)
}

/// An image has the texels that it says, all of them colours; returns the largest part of
/// any of these colours.
pub fn texels(image: &Texels) -> std::result::Result<f32, Flaw> {
    let (width, height) = (u64::from(image.width), u64::from(image.height));
    let count = image.texels.len();
    require(width * height == count as u64 && count > 0, || {
        flaw(
            format!("an image of {width} x {height} has {count} texels"),
            "wrong count",
            "give width * height texels, at least one",
        )
    })?;
    let is_color = |x: f32| x >= 0.0 && f64::from(x) <= MAX_MAGNITUDE;
    let mut largest = 0.0f32;
    for (i, &[red, green, blue, alpha]) in image.texels.iter().enumerate() {
        let colors = [red, green, blue].into_iter().all(is_color);
        require(colors && (0.0..=1.0).contains(&alpha), || {
            flaw(
                format!("texel {i} is [{red}, {green}, {blue}, {alpha}]"),
                "not a colour",
                format!("keep red, green and blue from 0 to {MAX_MAGNITUDE:e}, alpha from 0 to 1"),
            )
        })?;
        largest = largest.max(red).max(green).max(blue);
    }
    Ok(largest)
}

/// The largest part of an image's colours, where the albedo is multiplied with it.
pub fn brightest_texel(largest: f32) -> Verdict {
    require(largest <= 1.0, || {
        flaw(
            format!("the image has colours up to {largest}, but a texture's end at 1"),
            "too bright",
            "a surface scatters no more than all of the light: scale the image down",
        )
    })
}

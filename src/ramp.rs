//! Colours for numbers: from dark violet over red to pale yellow in even steps of
//! lightness, so that a step looks the same wherever it is.

use std::sync::LazyLock;

use glam::DVec3;

use crate::color::rgb_from_lab;
use crate::frame::transfer::srgb_encode;

/// The colour of a share, 0 to 1.
pub(crate) fn ramp_color(share: f64) -> [u8; 3] {
    COLORS[(255.0 * share).round() as usize]
}

/// Lightness L* at the ends.
const LEAST_LIGHTNESS: f64 = 20.0;
const GREATEST_LIGHTNESS: f64 = 96.0;

/// Hues in degrees of L*a*b*, from violet over red to yellow.
const LEAST_HUE: f64 = 310.0;
const GREATEST_HUE: f64 = 460.0;

/// Chroma aimed at; less where a display cannot show that much.
const CHROMA: f64 = 75.0;

/// One colour for each share in steps of 1/255.
static COLORS: LazyLock<[[u8; 3]; 256]> =
    LazyLock::new(|| std::array::from_fn(|i| color_of(i as f64 / 255.0)));

fn color_of(share: f64) -> [u8; 3] {
    let mix = |from: f64, to: f64| from + (to - from) * share;
    let lightness = mix(LEAST_LIGHTNESS, GREATEST_LIGHTNESS);
    let (sin, cos) = mix(LEAST_HUE, GREATEST_HUE).to_radians().sin_cos();
    let lab = |chroma: f64| DVec3::new(lightness, chroma * cos, chroma * sin);
    let shown = |rgb: DVec3| rgb.min_element() >= 0.0 && rgb.max_element() <= 1.0;
    let chromas = (0..=CHROMA as u32)
        .rev()
        .map(|c| rgb_from_lab(lab(c.into())));
    let rgb = chromas
        .into_iter()
        .find(|rgb| shown(*rgb))
        .unwrap_or_default();
    rgb.to_array()
        .map(|c| (255.0 * srgb_encode(c)).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::lab_from_rgb;
    use crate::frame::transfer::srgb_decode;

    #[test]
    fn lightness_rises_in_even_steps() {
        let lightness = |rgb: [u8; 3]| {
            let linear = rgb.map(|c| srgb_decode(f64::from(c) / 255.0));
            lab_from_rgb(linear.into()).x
        };
        let step = (GREATEST_LIGHTNESS - LEAST_LIGHTNESS) / 255.0;
        for (i, rgb) in COLORS.iter().enumerate() {
            // Half a code in each channel is at most half a unit of L*.
            let even = LEAST_LIGHTNESS + step * i as f64;
            assert!((lightness(*rgb) - even).abs() < 0.5, "{i} {rgb:?}");
        }
    }

    #[test]
    fn colors_have_the_hues_they_are_said_to_have() {
        let [violet, red, yellow] = [0, 100, 255].map(|i| COLORS[i]);
        assert!(violet[2] > violet[0] && violet[0] > violet[1], "{violet:?}");
        assert!(red[0] > red[1] && red[0] > red[2], "{red:?}");
        assert!(
            yellow[0] > 230 && yellow[1] > 230 && yellow[2] < 230,
            "{yellow:?}"
        );
    }
}

//! A picture of where two pictures differ.

use super::tally::{Mark, Pair};
use crate::ramp::ramp_color;

/// What a difference picture shows, from dark violet over red to pale yellow in
/// even steps of lightness. Pixels that are equal in every bit are black, but
/// for the surroundings that FLIP takes in; pixels that differ in any layer,
/// however little, are at least dark violet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DifferenceMap {
    /// The FLIP error, 0..=1.
    Flip,
    /// The greatest absolute difference of the colour's channels, scaled so
    /// that the greatest finite one of the picture is palest.
    Absolute,
}

/// Each pixel's absolute difference, scaled to 0..=1.
pub(super) fn absolute(color: &Pair<'_>, pixels: usize) -> Vec<f32> {
    let gaps: Vec<f64> = (0..pixels).map(|i| color.abs_of_pixel(i)).collect();
    let finite = gaps.iter().copied().filter(|gap| gap.is_finite());
    let greatest = finite.fold(0.0, f64::max);
    let scaled = |gap: f64| {
        if gap > 0.0 {
            (gap / greatest).min(1.0)
        } else {
            0.0
        }
    };
    gaps.into_iter().map(|gap| scaled(gap) as f32).collect()
}

/// RGB bytes, three a pixel; no errors means that only layers beside colour are
/// there to differ.
pub(super) fn paint(marks: &[Mark], errors: Option<&[f32]>) -> Vec<u8> {
    let mut rgb = Vec::with_capacity(3 * marks.len());
    for (i, mark) in marks.iter().enumerate() {
        let error = errors.map_or(0.0, |errors| errors[i]);
        let color = if mark.different || error > 0.0 {
            ramp_color(f64::from(error))
        } else {
            [0; 3]
        };
        rgb.extend(color);
    }
    rgb
}

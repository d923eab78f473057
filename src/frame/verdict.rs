//! Pictures of errors: how far a picture is from the truth, pixel by pixel.

use serde::Serialize;

use crate::ramp::ramp_color;

/// What rounding to f32 alone can do, in ulp.
const ROUNDING_ULP: f64 = 0.5;

/// Errors from here on, in ulp, have the brightest colour: the same one in all pictures,
/// so that they can be compared.
const GREATEST_ULP: f64 = 1e6;

/// Nothing is hit.
const BLACK: [u8; 3] = [0; 3];

/// Right, or within rounding: dark, yet apart from the black of no hit.
const RIGHT: [u8; 3] = [28; 3];

/// Vermilion, sky blue and yellow of Okabe and Ito, which the colour-blind tell apart,
/// also on the greys.
const FALSE_MISS: [u8; 3] = [213, 94, 0];
const FALSE_HIT: [u8; 3] = [86, 180, 233];
const WRONG_SHAPE: [u8; 3] = [240, 228, 66];

/// Whether a ray met what it should have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// It met the right shape, or rightly none.
    Right,
    /// It met nothing where there is a shape.
    FalseMiss,
    /// It met a shape where there is none.
    FalseHit,
    /// It met another shape than the first one on its way.
    WrongShape,
}

/// Errors in ulp of f32 as RGB bytes, three a pixel: black for NaN, which stands for no
/// hit; dark grey up to half a unit, which rounding alone can make; then from dark violet
/// over red to pale yellow for a million and more, in even steps of the logarithm.
pub fn ulp_colors(errors: &[f64]) -> Vec<u8> {
    let colors: Vec<_> = errors.iter().map(|error| ulp_color(error.abs())).collect();
    colors.into_flattened()
}

fn ulp_color(error: f64) -> [u8; 3] {
    if error.is_nan() {
        BLACK
    } else if error <= ROUNDING_ULP {
        RIGHT
    } else {
        let share = (error / ROUNDING_ULP).ln() / (GREATEST_ULP / ROUNDING_ULP).ln();
        ramp_color(share.min(1.0))
    }
}

/// Wrong pixels in bright colours over the picture itself, which is darkened and without
/// colours: orange for a false miss, blue for a false hit, yellow for a wrong shape. Both
/// `base` and the result have three bytes a pixel.
///
/// # Panics
///
/// If `base` does not have three bytes for each verdict.
pub fn wrong_colors(base: &[u8], verdicts: &[Verdict]) -> Vec<u8> {
    let (pixels, rest) = base.as_chunks::<3>();
    assert_eq!((pixels.len(), rest.len()), (verdicts.len(), 0));
    let color = |(pixel, verdict): (&[u8; 3], &Verdict)| match verdict {
        Verdict::Right => dimmed(*pixel),
        Verdict::FalseMiss => FALSE_MISS,
        Verdict::FalseHit => FALSE_HIT,
        Verdict::WrongShape => WRONG_SHAPE,
    };
    let colors: Vec<_> = pixels.iter().zip(verdicts).map(color).collect();
    colors.into_flattened()
}

/// A grey, at most a third as light as white.
fn dimmed([red, green, blue]: [u8; 3]) -> [u8; 3] {
    // Weights of luma in eighths: near enough for a picture in the background.
    let luma = (2 * u32::from(red) + 5 * u32::from(green) + u32::from(blue)) / 8;
    [(luma / 3) as u8; 3]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_colored_by_their_logarithm() {
        let colors = |errors: &[f64]| ulp_colors(errors).as_chunks::<3>().0.to_vec();
        assert_eq!(
            colors(&[f64::NAN, 0.0, 0.5, -0.5]),
            [BLACK, RIGHT, RIGHT, RIGHT]
        );
        // The geometric mean of 0.5 and 1e6 is in the middle.
        let middle = (0.5 * 1e6_f64).sqrt();
        assert_eq!(
            colors(&[0.500001, middle, -middle, 1e6, 1e300, f64::INFINITY]),
            [0.0, 0.5, 0.5, 1.0, 1.0, 1.0].map(ramp_color)
        );
        assert_ne!(ramp_color(0.0), RIGHT);
        assert!(ulp_colors(&[]).is_empty());
    }

    #[test]
    fn wrong_pixels_stand_out_of_a_grey_picture() {
        let base = [255, 255, 255, 0, 0, 0, 9, 9, 9, 9, 9, 9, 9, 9, 9, 80, 0, 0];
        let verdicts = [
            Verdict::Right,
            Verdict::Right,
            Verdict::FalseMiss,
            Verdict::FalseHit,
            Verdict::WrongShape,
            Verdict::Right,
        ];
        let colors = wrong_colors(&base, &verdicts);
        let expected = [
            [85; 3],
            BLACK,
            FALSE_MISS,
            FALSE_HIT,
            WRONG_SHAPE,
            [6; 3], // 160 / 8 / 3
        ];
        assert_eq!(colors.as_chunks::<3>().0, expected);
    }

    #[test]
    #[should_panic = "assertion"]
    fn a_picture_of_another_size_is_refused() {
        wrong_colors(&[0; 3], &[Verdict::Right; 2]);
    }
}

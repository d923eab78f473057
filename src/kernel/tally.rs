//! The sum of a pixel's samples.

use super::vector::Vec3;
use crate::layout::{Pixel, Tally};

/// The bits of an f32's exponent: all set in infinities and in what is no number.
pub const EXPONENT: u32 = 0x7f80_0000;

/// What of a colour's channels the eye sees as brightness: Rec. 709.
pub const LUMINANCE: Vec3<f32> = Vec3 {
    x: 0.2126,
    y: 0.7152,
    z: 0.0722,
};

/// Whether a number is one, and finite: by its bits, for a driver may take it for granted.
fn is_sound(number: f32) -> bool {
    number.to_bits() & EXPONENT != EXPONENT
}

/// How bright a colour is.
pub fn luminance(color: Vec3<f32>) -> f32 {
    (LUMINANCE.x * color.x + LUMINANCE.y * color.y) + LUMINANCE.z * color.z
}

/// Adds a sample to the sum of those before it; one that is no number is counted and left out.
pub fn add_sample(sum: &mut Pixel, tally: &mut Tally, color: Vec3<f32>) {
    let bright = luminance(color);
    let square = bright * bright;
    if !(is_sound(color.x) && is_sound(color.y) && is_sound(color.z) && is_sound(square)) {
        tally.faults += 1;
        return;
    }
    sum.color = (Vec3::from(sum.color) + color).into();
    tally.squares += square;
}

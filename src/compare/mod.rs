//! How far two pictures are apart, in every layer.

mod difference;
pub mod flip;
mod sides;
mod tally;

pub use difference::DifferenceMap;
pub use tally::ulp_distance;

use serde::Serialize;

use crate::frame::{Frame, Picture};
use crate::{Error, Result};
use sides::Sides;

/// By how much two pictures may differ. A value is within tolerance where its
/// bits are equal, or its ulp distance is at most `max_ulp`, or its absolute
/// difference is at most `max_abs`; an id must be equal. The default is all
/// zero: bit for bit.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Tolerance {
    /// Units in the last place; 0 takes this way out away.
    pub max_ulp: u32,
    /// Absolute difference; 0 takes this way out away.
    pub max_abs: f64,
    /// How many pixels may have a value out of tolerance.
    pub different_pixels: u64,
}

impl Tolerance {
    fn check(&self) -> Result<()> {
        if self.max_abs >= 0.0 {
            return Ok(());
        }
        Err(Error::Usage(format!(
            "the tolerance max_abs is {}: it takes a number of at least 0",
            self.max_abs
        )))
    }
}

/// What [`compare_frames`] and [`compare_pictures`] find. `max_abs`, `rmse`,
/// `psnr_db` and `flip` are over colour: linear for frames and EXR files, the
/// encoded values scaled to 0..=1 for PNG files. An infinite number becomes
/// `null` in JSON.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// What stands on the left.
    pub left: String,
    /// What stands on the right.
    pub right: String,
    /// How many pixels each side has.
    pub pixels: u64,
    /// Pixels with any bit of any layer different; +0 and -0 differ, and so do
    /// two NaN of different bits.
    pub different_pixels: u64,
    /// Pixels with a value out of tolerance.
    pub outside_pixels: u64,
    /// The greatest absolute difference of a channel of colour, infinite where
    /// only one of two values is finite. Where files hold no colour, this and
    /// `rmse` are over all their floats.
    pub max_abs: f64,
    /// Root of the mean squared difference over pixels and channels.
    pub rmse: f64,
    /// Peak signal-to-noise ratio in dB with a peak of 1, -20 log10(rmse);
    /// `None` where `rmse` is 0 or infinite.
    pub psnr_db: Option<f64>,
    /// Mean LDR-FLIP error, 0..=1, of what a display shows (see [`flip`]);
    /// `None` where files hold no colour.
    pub flip: Option<f64>,
    /// Pixels whose ids differ.
    pub id_mismatches: u64,
    /// The greatest ulp distance over all float layers, see [`ulp_distance`];
    /// for PNG files in steps of the finer of the two files' codes.
    pub max_ulp: u32,
    /// Whether `outside_pixels` is at most what the tolerance allows.
    pub pass: bool,
    /// What was allowed.
    pub tolerance: Tolerance,
    /// The same, layer by layer.
    pub layers: Vec<LayerDifference>,
}

/// How far two pictures are apart in one layer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LayerDifference {
    /// The layer, or the channel of an EXR file.
    pub layer: String,
    /// Pixels with any bit different.
    pub different_pixels: u64,
    /// The greatest absolute difference; `None` for ids.
    pub max_abs: Option<f64>,
    /// The greatest ulp distance; `None` for ids.
    pub max_ulp: Option<u32>,
}

/// Compares two frames over all layers.
///
/// # Errors
/// [`Error::Usage`] where the sizes differ or the tolerance is no number.
pub fn compare_frames(left: &Frame, right: &Frame, tolerance: &Tolerance) -> Result<Comparison> {
    tolerance.check()?;
    Ok(Sides::of_frames(left, right)?.compare(tolerance))
}

/// Compares two files over all channels.
///
/// # Errors
/// [`Error::Usage`] where the sizes or the channels differ, or where one is a
/// PNG and the other an EXR: the tone curve between them is not known.
pub fn compare_pictures(
    left: &Picture,
    right: &Picture,
    tolerance: &Tolerance,
) -> Result<Comparison> {
    tolerance.check()?;
    Ok(Sides::of_pictures(left, right)?.compare(tolerance))
}

/// Shows where two frames differ: RGB bytes, three a pixel, row by row from the
/// top left, see [`DifferenceMap`].
///
/// # Errors
/// As [`compare_frames`].
pub fn difference_of_frames(left: &Frame, right: &Frame, map: DifferenceMap) -> Result<Vec<u8>> {
    Ok(Sides::of_frames(left, right)?.difference_picture(map))
}

/// Shows where two files differ, as [`difference_of_frames`] does.
///
/// # Errors
/// As [`compare_pictures`].
pub fn difference_of_pictures(
    left: &Picture,
    right: &Picture,
    map: DifferenceMap,
) -> Result<Vec<u8>> {
    Ok(Sides::of_pictures(left, right)?.difference_picture(map))
}

#[cfg(test)]
mod tests;

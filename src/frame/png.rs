//! PNG: a layer written in 8 bits, a picture read with 8 or 16.

use std::io::Cursor;
use std::path::Path;

use image::codecs::png::{PngDecoder, PngEncoder};
use image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder, ImageError, Limits};

use super::memory::reserve_pixels;
use super::output::{output_error, write_atomically};
use super::picture::asset_error;
use super::{Frame, Layer, PictureValues};
use crate::scene::Transfer;
use crate::{Error, Result};

/// Decoding holds a picture as decoded, as RGBA and as RGB, 16 bits each.
const BYTES_PER_PIXEL: u64 = 8 + 8 + 6;

impl Frame {
    /// Writes one layer as [`Frame::to_rgb8`] shows it.
    ///
    /// # Errors
    /// [`Error::Output`]; the old file, if any, is then untouched.
    pub fn write_png(&self, path: &Path, layer: Layer, transfer: Transfer) -> Result<()> {
        self.check_lengths()?;
        let rgb = self.to_rgb8(layer, transfer);
        write_rgb8(path, self.width, self.height, &rgb)
    }
}

/// Writes `width * height` pixels of three bytes, row by row from the top left,
/// as a PNG.
///
/// # Errors
/// [`Error::Usage`] where the number of bytes does not fit the size,
/// [`Error::Output`] where the file cannot be written; the old one, if any, is
/// then untouched.
pub fn write_rgb8(path: &Path, width: u32, height: u32, rgb: &[u8]) -> Result<()> {
    if rgb.len() as u128 != 3 * u128::from(width) * u128::from(height) {
        return Err(Error::Usage(format!(
            "{} bytes are no picture of {width} x {height} RGB pixels",
            rgb.len()
        )));
    }
    let mut file = Vec::new();
    PngEncoder::new(&mut file)
        .write_image(rgb, width, height, ExtendedColorType::Rgb8)
        .map_err(|e| output_error(path, std::io::Error::other(e)))?;
    write_atomically(path, &file)
}

/// Decodes a PNG file's bytes; `path` is for messages.
pub(super) fn read(path: &Path, file: &[u8]) -> Result<(u32, u32, PictureValues)> {
    let broken = |e: ImageError| match e {
        ImageError::Limits(e) => Error::Limit(format!("{}: {e}", path.display())),
        e => asset_error(path, format!("broken PNG: {e}")),
    };

    // The limits bound what the chunks beside the pixels may take.
    let decoder = PngDecoder::with_limits(Cursor::new(file), Limits::default()).map_err(broken)?;
    let (width, height) = decoder.dimensions();
    reserve_pixels(width, height, BYTES_PER_PIXEL)?;
    let image = DynamicImage::from_decoder(decoder).map_err(broken)?;
    let channels = image.color().channel_count();
    let bits = image.color().bits_per_pixel() / u16::from(channels);

    let rgba = image.into_rgba16();
    if let Some(at) = rgba.pixels().position(|p| p.0[3] != u16::MAX) {
        let (x, y) = (at % width as usize, at / width as usize);
        let message = format!(
            "pixel {x}, {y} is transparent, which a comparison cannot judge: \
             put the picture on a background first"
        );
        return Err(asset_error(path, message));
    }
    let codes = rgba.pixels().map(|p| [p.0[0], p.0[1], p.0[2]]).collect();
    Ok((width, height, PictureValues::Encoded { bits, codes }))
}

//! From a file's bytes to texels in linear light.

use std::io::Cursor;
use std::path::Path;
use std::sync::LazyLock;

use image::codecs::hdr::HdrDecoder;
use image::codecs::png::PngDecoder;
use image::{DynamicImage, ImageDecoder, Limits};
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

use super::{Room, asset_error};
use crate::Result;
use crate::frame::transfer::srgb_decode;
use crate::frame::{Channel, PictureValues, Samples, exr};
use crate::scene::Texels;

const PNG_SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
const JPEG_SIGNATURE: &[u8] = b"\xff\xd8\xff";
const EXR_SIGNATURE: &[u8] = b"\x76\x2f\x31\x01";
const HDR_SIGNATURE: &[u8] = b"#?RADIANCE";
/// The other first line that programs write.
const RGBE_SIGNATURE: &[u8] = b"#?RGBE";

/// Bytes that a PNG's chunks beside the pixels may take.
const PNG_CHUNKS: u64 = 64 << 20;

/// Linear light of each code of 16 bits; a code c of 8 bits is 257 c, the same fraction.
static LINEAR: LazyLock<Vec<f32>> = LazyLock::new(|| {
    (0..=u16::MAX)
        .map(|code| srgb_decode(fraction(code)) as f32)
        .collect()
});

fn fraction(code: u16) -> f64 {
    f64::from(code) / f64::from(u16::MAX)
}

/// What is wrong with a file, in words.
type Decoded = std::result::Result<Texels, String>;

/// An image from a file's bytes; `path` is its name.
pub(super) fn decode(path: &Path, file: &[u8], room: &Room) -> Result<Texels> {
    let decoded = if file.starts_with(PNG_SIGNATURE) {
        png(file, room)
    } else if file.starts_with(JPEG_SIGNATURE) {
        jpeg(file, room)
    } else if file.starts_with(HDR_SIGNATURE) || file.starts_with(RGBE_SIGNATURE) {
        hdr(file, room)
    } else if file.starts_with(EXR_SIGNATURE) {
        exr(path, file, room)?
    } else {
        Err("is no PNG, JPEG, OpenEXR or Radiance HDR file; save the image as one of them".into())
    };
    let name = path.display().to_string();
    decoded
        .map(|texels| Texels { name, ..texels })
        .map_err(|message| asset_error(path, message))
}

fn png(file: &[u8], room: &Room) -> Decoded {
    let broken = |error| format!("broken PNG: {error}");
    let mut limits = Limits::default();
    // A texel has 8 bytes at most, and is held twice.
    limits.max_alloc = Some(room.left().saturating_mul(16).saturating_add(PNG_CHUNKS));
    let decoder = PngDecoder::with_limits(Cursor::new(file), limits).map_err(broken)?;
    let (width, height) = decoder.dimensions();
    room.check(width.into(), height.into())?;
    let image = DynamicImage::from_decoder(decoder).map_err(broken)?;
    let codes = image.into_rgba16();
    let texels = codes.pixels().map(|pixel| {
        let [r, g, b, a] = pixel.0;
        let [r, g, b] = [r, g, b].map(|code| LINEAR[usize::from(code)]);
        [r, g, b, fraction(a) as f32]
    });
    Ok(unnamed(width, height, texels.collect()))
}

fn jpeg(file: &[u8], room: &Room) -> Decoded {
    let broken = |error| format!("broken JPEG: {error}");
    // Strict, for otherwise what is missing at the end comes out grey; without the vector
    // instructions of some machines, for a file shall be the same image on all of them.
    let options = DecoderOptions::new_safe()
        .set_strict_mode(true)
        .set_max_width(usize::from(u16::MAX))
        .set_max_height(usize::from(u16::MAX))
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(file), options);
    decoder.decode_headers().map_err(broken)?;
    let (width, height) = decoder.dimensions().unwrap_or((0, 0));
    room.check(width as u64, height as u64)?;
    let codes = decoder.decode().map_err(broken)?;
    let (codes, _) = codes.as_chunks::<3>();
    let texels = codes.iter().map(|&codes| {
        let [r, g, b] = codes.map(|code| LINEAR[257 * usize::from(code)]);
        [r, g, b, 1.0]
    });
    // The format holds a side in 16 bits.
    Ok(unnamed(width as u32, height as u32, texels.collect()))
}

fn hdr(file: &[u8], room: &Room) -> Decoded {
    let broken = |error| format!("broken HDR: {error}");
    let decoder = if file.starts_with(HDR_SIGNATURE) {
        HdrDecoder::new(file)
    } else {
        HdrDecoder::new_nonstrict(file)
    };
    let decoder = decoder.map_err(broken)?;
    let (width, height) = decoder.dimensions();
    room.check(width.into(), height.into())?;
    let image = DynamicImage::from_decoder(decoder).map_err(broken)?;
    let colors = image.into_rgb32f();
    let texels = colors.pixels().map(|pixel| {
        let [r, g, b] = pixel.0;
        [r, g, b, 1.0]
    });
    Ok(unnamed(width, height, texels.collect()))
}

fn exr(path: &Path, file: &[u8], room: &Room) -> Result<Decoded> {
    let (width, height, values) =
        exr::read(path, file, &|width, height| room.check(width, height))?;
    let (color, channels) = match values {
        PictureValues::Linear { color, channels } => (color, channels),
        PictureValues::Encoded { .. } => (None, Vec::new()),
    };
    let float = |name: &str| {
        channels.iter().find_map(|channel| match channel {
            Channel {
                name: its,
                samples: Samples::Float(values),
            } if its == name => Some(values),
            _ => None,
        })
    };
    let grey = || float("Y").map(|grey| grey.iter().map(|&y| [y; 3]).collect());
    let Some(color) = color.or_else(grey) else {
        return Ok(Err(
            "this EXR has neither the channels R, G and B nor Y, as floats".into(),
        ));
    };
    let alpha = float("A");
    let texels = color.into_iter().enumerate().map(|(i, [r, g, b])| {
        let alpha = alpha.map_or(1.0, |alpha| alpha[i]);
        [r, g, b, alpha]
    });
    Ok(Ok(unnamed(width, height, texels.collect())))
}

fn unnamed(width: u32, height: u32, texels: Vec<[f32; 4]>) -> Texels {
    Texels {
        name: String::new(),
        width,
        height,
        texels,
    }
}

//! A picture file read back, to be compared.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::{exr, png};
use crate::{Error, Result};

/// No picture that fits in memory makes a larger file.
const MAX_FILE_BYTES: u64 = 1 << 36;

const PNG_SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
const EXR_SIGNATURE: &[u8] = b"\x76\x2f\x31\x01";

/// What an image file holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The file, for messages and reports.
    pub name: String,
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
    /// The pixels.
    pub values: PictureValues,
}

/// The pixels of an image file, row by row from the top left.
#[derive(Debug, Clone, PartialEq)]
pub enum PictureValues {
    /// A PNG: RGB after the tone curve.
    Encoded {
        /// Bits a channel in the file, 8 or 16.
        bits: u16,
        /// Codes on the scale of 16 bits: 0 to 65535, where a code c of 8 bits
        /// is 257 c. Greys are spread over the three channels.
        codes: Vec<[u16; 3]>,
    },
    /// An EXR: values as rendered.
    Linear {
        /// The channels R, G and B, if the file has all three as floats.
        color: Option<Vec<[f32; 3]>>,
        /// All other channels in the order of their names.
        channels: Vec<Channel>,
    },
}

/// One channel of an EXR file.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// Its full name, such as `depth.Z`.
    pub name: String,
    /// One value a pixel.
    pub samples: Samples,
}

/// The values of a channel.
#[derive(Debug, Clone, PartialEq)]
pub enum Samples {
    /// Floats; halves are widened, which is exact.
    Float(Vec<f32>),
    /// Integers, such as primitive ids.
    Integer(Vec<u32>),
}

/// Reads a PNG (8 or 16 bits, grey or colour, opaque) or an EXR (one part, not
/// deep, not subsampled). Contents decide, not the file's name. Colour profiles
/// are not applied.
///
/// # Errors
/// [`Error::Asset`] where the file is missing, broken, or of another kind;
/// [`Error::Limit`] where it takes more memory than there is.
pub fn read_image(path: &Path) -> Result<Picture> {
    let file = read_file(path).map_err(|e| asset_error(path, e.to_string()))?;
    decode(path, &file)
}

/// A picture from a file's bytes; `path` is its name.
fn decode(path: &Path, file: &[u8]) -> Result<Picture> {
    let (width, height, values) = if file.starts_with(PNG_SIGNATURE) {
        png::read(path, file)?
    } else if file.starts_with(EXR_SIGNATURE) {
        exr::read(path, file, &|_, _| Ok(()))?
    } else {
        let message = "neither a PNG nor an EXR file: only these two can be compared";
        return Err(asset_error(path, message));
    };
    Ok(Picture {
        name: path.display().to_string(),
        width,
        height,
        values,
    })
}

pub(super) fn asset_error(path: &Path, message: impl Into<String>) -> Error {
    Error::Asset {
        path: path.to_owned(),
        line: None,
        message: message.into(),
    }
}

fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    // A pipe would block and a device might never end.
    let metadata = std::fs::metadata(path)?;
    if !metadata.is_file() {
        return Err(io::Error::other("not a regular file"));
    }
    if metadata.len() > MAX_FILE_BYTES {
        let message = format!(
            "{} bytes: at most {MAX_FILE_BYTES} are read",
            metadata.len()
        );
        return Err(io::Error::other(message));
    }
    let mut bytes = Vec::new();
    File::open(path)?
        .take(MAX_FILE_BYTES)
        .read_to_end(&mut bytes)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests;

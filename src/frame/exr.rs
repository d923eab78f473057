//! OpenEXR: layers written bit for bit, all channels read.

use std::io::Cursor;
use std::path::Path;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, LayerAttributes, ReadChannels,
    ReadLayers, SmallVec, WritableImage,
};

use super::memory::reserve_pixels;
use super::output::{output_error, write_atomically};
use super::picture::asset_error;
use super::{Channel, Frame, Layer, PictureValues, Samples};
use crate::{Error, Result};

/// A channel's values are held as read and as given back.
const BYTES_PER_SAMPLE: u64 = 4 + 4;

impl Frame {
    /// Writes layers as channels of one EXR part, as [`Frame::write_exr_with`].
    ///
    /// # Errors
    /// As there.
    pub fn write_exr(&self, path: &Path, layers: &[Layer]) -> Result<()> {
        self.write_exr_with(path, layers, Vec::new())
    }

    /// Writes layers as channels of one EXR part, bit for bit: colour as
    /// `R`, `G`, `B`, depth as `depth.Z`, normal and position as `normal.X` and
    /// so on, all 32-bit floats, and id as the 32-bit integer `id`. Further channels of
    /// integers, one for each pixel, come with their names.
    ///
    /// # Errors
    /// [`Error::Usage`] for an empty list of layers; [`Error::Output`], and the
    /// old file, if any, is then untouched.
    pub fn write_exr_with(
        &self,
        path: &Path,
        layers: &[Layer],
        further: Vec<(&str, Vec<u32>)>,
    ) -> Result<()> {
        self.check_lengths()?;
        if layers.is_empty() && further.is_empty() {
            return Err(Error::Usage("an EXR file takes at least one layer".into()));
        }
        let mut channels = SmallVec::new();
        for layer in Layer::ALL.into_iter().filter(|l| layers.contains(l)) {
            match layer {
                Layer::Color => channels.extend(split(["R", "G", "B"], &self.color)),
                Layer::Depth => channels.push(AnyChannel::new(
                    "depth.Z",
                    FlatSamples::F32(self.depth.clone()),
                )),
                Layer::Normal => {
                    channels.extend(split(["normal.X", "normal.Y", "normal.Z"], &self.normal))
                }
                Layer::Position => channels.extend(split(
                    ["position.X", "position.Y", "position.Z"],
                    &self.position,
                )),
                Layer::Id => {
                    channels.push(AnyChannel::new("id", FlatSamples::U32(self.id.clone())))
                }
            }
        }
        for (name, values) in further {
            channels.push(AnyChannel::new(name, FlatSamples::U32(values)));
        }
        let attributes = LayerAttributes {
            software_name: Some("rayproof".into()),
            ..LayerAttributes::default()
        };
        let image = Image::from_layer(exr::prelude::Layer::new(
            (self.width as usize, self.height as usize),
            attributes,
            // Lossless, and the kind of file that every program reads.
            Encoding::SMALL_LOSSLESS,
            AnyChannels::sort(channels),
        ));
        let mut file = Cursor::new(Vec::new());
        image
            .write()
            .non_parallel()
            .to_buffered(&mut file)
            .map_err(|e| output_error(path, std::io::Error::other(e)))?;
        write_atomically(path, file.get_ref())
    }
}

/// One channel for each component.
fn split(names: [&str; 3], pixels: &[[f32; 3]]) -> [AnyChannel<FlatSamples>; 3] {
    [0, 1, 2].map(|axis| {
        let samples = pixels.iter().map(|p| p[axis]).collect();
        AnyChannel::new(names[axis], FlatSamples::F32(samples))
    })
}

/// Whether a picture of this width and height may be decoded; else why not.
pub(crate) type Fits<'a> = &'a dyn Fn(u64, u64) -> std::result::Result<(), String>;

/// Decodes an EXR file's bytes, if its size fits; `path` is for messages.
pub(crate) fn read(path: &Path, file: &[u8], fits: Fits<'_>) -> Result<(u32, u32, PictureValues)> {
    let broken = |e: exr::error::Error| asset_error(path, format!("broken EXR: {e}"));
    let refused = |what: String| asset_error(path, format!("this EXR {what}"));

    // Strict reading: a file whose blocks are missing or double is broken.
    const PEDANTIC: bool = true;
    let chunks = exr::block::read(Cursor::new(file), PEDANTIC).map_err(broken)?;
    let header = match chunks.headers() {
        [header] => header,
        parts => {
            return Err(refused(format!(
                "has {} parts: only one is read",
                parts.len()
            )));
        }
    };
    if header.deep {
        return Err(refused("is deep: only flat pictures are read".into()));
    }
    let channels = &header.channels.list;
    if let Some(channel) = channels
        .iter()
        .find(|c| c.sampling.0 != 1 || c.sampling.1 != 1)
    {
        return Err(refused(format!(
            "has the subsampled channel '{}'",
            channel.name
        )));
    }
    let side = |pixels| {
        u32::try_from(pixels).map_err(|_| refused(format!("is {pixels} pixels on one side")))
    };
    let (width, height) = (side(header.layer_size.0)?, side(header.layer_size.1)?);
    fits(width.into(), height.into()).map_err(|message| asset_error(path, message))?;
    reserve_pixels(width, height, BYTES_PER_SAMPLE * channels.len() as u64)?;

    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .pedantic()
        .non_parallel()
        .from_chunks(chunks)
        .map_err(broken)?;
    let channels = image.layer_data.channel_data.list.into_iter().map(channel);
    Ok((width, height, with_color(channels.collect())))
}

fn channel(channel: AnyChannel<FlatSamples>) -> Channel {
    Channel {
        name: channel.name.to_string(),
        samples: match channel.sample_data {
            FlatSamples::F16(halves) => {
                Samples::Float(halves.into_iter().map(|h| h.to_f32()).collect())
            }
            FlatSamples::F32(floats) => Samples::Float(floats),
            FlatSamples::U32(integers) => Samples::Integer(integers),
        },
    }
}

/// Takes R, G and B out of the channels and puts them side by side.
fn with_color(channels: Vec<Channel>) -> PictureValues {
    let float = |name: &str| {
        channels.iter().find_map(|c| match &c.samples {
            Samples::Float(values) if c.name == name => Some(values),
            _ => None,
        })
    };
    let color = match (float("R"), float("G"), float("B")) {
        (Some(r), Some(g), Some(b)) => {
            let pixels = r.iter().zip(g).zip(b);
            Some(pixels.map(|((&r, &g), &b)| [r, g, b]).collect())
        }
        _ => None,
    };
    let channels = match color {
        Some(_) => {
            let is_color = |c: &Channel| ["R", "G", "B"].contains(&c.name.as_str());
            channels.into_iter().filter(|c| !is_color(c)).collect()
        }
        None => channels,
    };
    PictureValues::Linear { color, channels }
}

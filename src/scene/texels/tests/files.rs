//! Image files, made in memory.

use std::io::Cursor;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Layer, LayerAttributes, SmallVec, WritableImage,
};
use image::codecs::hdr::HdrEncoder;
use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder, Rgb};

pub fn png_of(bytes: &[u8], width: u32, height: u32, kind: ExtendedColorType) -> Vec<u8> {
    let mut file = Vec::new();
    PngEncoder::new(&mut file)
        .write_image(bytes, width, height, kind)
        .expect("in memory");
    file
}

pub fn jpeg_of(bytes: &[u8], width: u32, height: u32, kind: ExtendedColorType) -> Vec<u8> {
    let mut file = Vec::new();
    JpegEncoder::new_with_quality(&mut file, 100)
        .encode(bytes, width, height, kind)
        .expect("in memory");
    file
}

pub fn hdr_of(texels: &[[f32; 3]], width: usize, height: usize) -> Vec<u8> {
    let mut file = Vec::new();
    let texels: Vec<_> = texels.iter().map(|&texel| Rgb(texel)).collect();
    HdrEncoder::new(&mut file)
        .encode(&texels, width, height)
        .expect("in memory");
    file
}

pub fn exr_of(size: (usize, usize), channels: &[(&str, &[f32])]) -> Vec<u8> {
    let channels = channels
        .iter()
        .map(|&(name, values)| AnyChannel::new(name, FlatSamples::F32(values.to_vec())))
        .collect::<SmallVec<_>>();
    let layer = Layer::new(
        size,
        LayerAttributes::default(),
        Encoding::SMALL_LOSSLESS,
        AnyChannels::sort(channels),
    );
    let mut file = Cursor::new(Vec::new());
    exr::prelude::Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut file)
        .expect("in memory");
    file.into_inner()
}

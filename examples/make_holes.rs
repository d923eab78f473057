//! Writes the texture of `assets/scenes/motion.toml`: white, with a round hole in its middle.
//!
//! ```console
//! $ cargo run --example make_holes -- assets/scenes/textures/holes.png
//! ```
//!
//! Where the alpha of an image is below 1/2, a material with `alpha = "cutout"` has a hole.
//! Alpha is blended between texels, so a hole is as round as the alpha's slope is even.

use image::{Rgba, RgbaImage};

const SIZE: u32 = 64;

/// The hole's radius in texels.
const RADIUS: f64 = 0.36 * SIZE as f64;

/// How many texels the alpha takes from 0 to 1.
const SLOPE: f64 = 4.0;

fn main() -> Result<(), image::ImageError> {
    let file = std::env::args().nth(1);
    let file = file
        .as_deref()
        .unwrap_or("assets/scenes/textures/holes.png");
    RgbaImage::from_fn(SIZE, SIZE, texel).save(file)
}

fn texel(x: u32, y: u32) -> Rgba<u8> {
    let from_middle = |place: u32| f64::from(place) + 0.5 - f64::from(SIZE) / 2.0;
    let distance = from_middle(x).hypot(from_middle(y));
    let alpha = ((distance - RADIUS) / SLOPE + 0.5).clamp(0.0, 1.0);
    Rgba([255, 255, 255, (255.0 * alpha).round() as u8])
}

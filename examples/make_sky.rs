//! Writes the sky of `assets/scenes/sky-teapot.toml`: dusk, as an image of all directions.
//!
//! ```console
//! $ cargo run --example make_sky -- assets/scenes/skies/dusk.exr
//! ```
//!
//! The image's upper edge is +y, its middle x with z to the right of it, as `[environment]`
//! wants it. The real sun is smaller than a texel; this one is a few texels wide, so that
//! its shadows are soft.

use std::path::Path;

use glam::{DVec3, dvec3};
use rayproof::{Error, Frame, Layer};

const WIDTH: u32 = 256;
const HEIGHT: u32 = 128;

/// Radiance at the zenith, well above the horizon, at the horizon, and of the ground.
const ZENITH: DVec3 = dvec3(0.05, 0.1, 0.28);
const MIDDLE: DVec3 = dvec3(0.24, 0.3, 0.48);
const HORIZON: DVec3 = dvec3(0.8, 0.46, 0.3);
const GROUND: DVec3 = dvec3(0.05, 0.045, 0.045);

/// Radiance that the sun's haze adds near it.
const GLOW: DVec3 = dvec3(1.6, 0.75, 0.25);

/// Radiance of the sun, and the degrees from its middle to its edge: a dozen of the real one's.
const SUN: DVec3 = dvec3(210.0, 122.0, 54.0);
const SUN_RADIUS: f64 = 3.6;

/// Degrees of the sun above the horizon, and from x towards z.
const SUN_HEIGHT: f64 = 14.0;
const SUN_TURN: f64 = 0.0;

/// A texel is made of this many places by as many, so that the sun's edge is smooth.
const PLACES: u32 = 4;

fn main() -> miette::Result<()> {
    let file = std::env::args().nth(1);
    let file = file.as_deref().unwrap_or("assets/scenes/skies/dusk.exr");
    Ok(write_sky(Path::new(file))?)
}

fn write_sky(file: &Path) -> Result<(), Error> {
    let mut frame = Frame::new(WIDTH, HEIGHT)?;
    let texels = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    frame.color = texels.map(|(x, y)| texel(x, y)).collect();
    frame.write_exr(file, &[Layer::Color])
}

/// The mean radiance of a texel.
fn texel(x: u32, y: u32) -> [f32; 3] {
    let places = (0..PLACES).flat_map(|j| (0..PLACES).map(move |i| (i, j)));
    let within =
        |texel: u32, place: u32| f64::from(texel) + (f64::from(place) + 0.5) / f64::from(PLACES);
    let sum: DVec3 = places
        .map(|(i, j)| radiance(direction(within(x, i), within(y, j))))
        .sum();
    let mean = sum / f64::from(PLACES * PLACES);
    mean.to_array().map(|channel| rounded(channel as f32))
}

/// The unit direction of a place in the image, in texels from its upper left corner.
fn direction(x: f64, y: f64) -> DVec3 {
    let turn = (x / f64::from(WIDTH) - 0.5) * std::f64::consts::TAU;
    let height = (0.5 - y / f64::from(HEIGHT)) * std::f64::consts::PI;
    dvec3(
        height.cos() * turn.cos(),
        height.sin(),
        height.cos() * turn.sin(),
    )
}

/// What is seen in a direction.
fn radiance(direction: DVec3) -> DVec3 {
    let degrees_from_sun = direction.angle_between(sun_direction()).to_degrees();
    let height = direction.y;
    // The ground grows out of the haze within a few degrees.
    let haze = (1.0 - (-height / 0.06).clamp(0.0, 1.0)).powi(2);
    if height < 0.0 {
        return GROUND.lerp(HORIZON * 0.5, haze);
    }
    let low = (-height / 0.1).exp();
    let middle = (-height / 0.45).exp();
    let sky = ZENITH.lerp(MIDDLE, middle).lerp(HORIZON, low);
    let glow =
        GLOW * ((-degrees_from_sun / 9.0).exp() + 0.25 * (-degrees_from_sun / 35.0).exp() * low);
    if degrees_from_sun < SUN_RADIUS {
        return SUN;
    }
    sky + glow
}

fn sun_direction() -> DVec3 {
    let (turn, height) = (SUN_TURN.to_radians(), SUN_HEIGHT.to_radians());
    dvec3(
        height.cos() * turn.cos(),
        height.sin(),
        height.cos() * turn.sin(),
    )
}

/// The number with the upper 12 bits of its fraction: the file packs better so, and no step
/// is seen.
fn rounded(channel: f32) -> f32 {
    f32::from_bits((channel.to_bits() + (1 << 10)) & !((1 << 11) - 1))
}

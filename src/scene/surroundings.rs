//! What is all around: the background, the environment that shines, the fog.

use std::sync::Arc;

use super::Rgb;
use super::texture::Texels;

/// What a ray sees that meets nothing: with w = `offset` + `slope` * d.y, where
/// d is the ray's unit direction, the colour is `from` * (1 - w) + `to` * w.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Background {
    /// The colour at w = 0.
    pub from: Rgb,
    /// The colour at w = 1.
    pub to: Rgb,
    /// w at the horizon.
    pub offset: f64,
    /// Change of w from the horizon to the zenith.
    pub slope: f64,
}

impl Background {
    /// The same colour everywhere.
    pub fn plain(color: Rgb) -> Self {
        Self {
            from: color,
            to: color,
            offset: 0.0,
            slope: 0.0,
        }
    }
}

/// Light from infinitely far away, from all sides; a ray that meets nothing sees it.
#[derive(Debug, Clone, PartialEq)]
pub struct Environment {
    /// What it looks like.
    pub sky: Sky,
    /// Every radiance is multiplied by this.
    pub intensity: f64,
    /// By how many degrees it is turned about the y axis, from x towards -z.
    pub turn_degrees: f64,
}

/// What an environment looks like.
#[derive(Debug, Clone, PartialEq)]
pub enum Sky {
    /// A blend of two colours by height, or one colour.
    Gradient(Background),
    /// An image of all directions: its left edge and right edge meet behind, in -x, its
    /// middle is x, with z to the right of it, and its upper edge is +y.
    Image(Arc<Texels>),
}

/// A medium that is the same everywhere, and scatters light evenly to all sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fog {
    /// What is taken out of a ray of light in a unit of length, as a rate: exp(-`density`
    /// d) is left after d.
    pub density: f64,
    /// The fraction of that which is scattered, per channel; the rest is lost.
    pub albedo: Rgb,
}

//! Materials: how surfaces answer light.

use super::Rgb;
use super::texture::Texture;

/// How a surface answers light.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// The name by which a scene file refers to it.
    pub name: String,
    /// The fraction of light that a Lambert surface scatters, per channel.
    pub albedo: Rgb,
    /// The fraction of light that is thrown back as by a mirror, seen straight on, per
    /// channel; seen askew it is more (Schlick). What is left meets the albedo.
    pub mirror: Rgb,
    /// How rough the mirror is: 0 is smooth, 1 all but matt. Its square is the width of the
    /// distribution of Trowbridge and Reitz (GGX). One that is not smooth counts as 1/32 at
    /// least.
    pub roughness: f64,
    /// Index of refraction of a clear body; none where the body is not clear. Nothing is
    /// scattered then.
    pub ior: Option<f64>,
    /// What a clear body takes out of a ray in a unit of length, as a rate, per channel.
    pub absorption: Rgb,
    /// Radiance of the surface by itself.
    pub emission: Rgb,
    /// What the albedo is multiplied by from place to place.
    pub texture: Option<Texture>,
    /// Whether there is a hole where the texture's alpha is below 1/2.
    pub cutout: bool,
}

impl Default for Material {
    /// Matt and light grey.
    fn default() -> Self {
        Self {
            name: "default".into(),
            albedo: [0.8; 3],
            mirror: [0.0; 3],
            roughness: 0.0,
            ior: None,
            absorption: [0.0; 3],
            emission: [0.0; 3],
            texture: None,
            cutout: false,
        }
    }
}

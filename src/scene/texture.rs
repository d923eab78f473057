//! Textures: what colours a surface from place to place.

use std::sync::Arc;

use super::Rgb;

/// What the albedo is multiplied by from place to place.
///
/// A triangle with texture coordinates takes those, a sphere its longitude and latitude, each
/// times `repeat`; any other surface its coordinates along the two axes that it lies most
/// along, in units of `size`.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// What repeats.
    pub pattern: Pattern,
    /// How often it repeats over the texture coordinates, across and upward.
    pub repeat: [f64; 2],
    /// The length of one repeat in the world, where there are no coordinates.
    pub size: f64,
}

/// What a texture repeats.
#[derive(Debug, Clone, PartialEq)]
pub enum Pattern {
    /// Two by two squares, by turns white and of this colour.
    Checker(Rgb),
    /// An image.
    Image(Arc<Texels>),
}

/// An image in linear light.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Texels {
    /// The file, for messages.
    pub name: String,
    /// Texels from left to right.
    pub width: u32,
    /// Texels from top to bottom.
    pub height: u32,
    /// Red, green, blue and alpha, row by row from the top.
    pub texels: Vec<[f32; 4]>,
}

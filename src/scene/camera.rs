//! The camera and its picture.

use glam::DVec3;

/// Size and tone curve of the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Image {
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
    /// From linear light to the 8 bits of a PNG.
    pub transfer: Transfer,
}

/// From linear light to the 8 bits of a PNG.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Transfer {
    /// The piecewise curve of IEC 61966-2-1.
    Srgb,
    /// Square root, then floor(255.99 c): the curve of the 2017 report.
    Sqrt,
    /// No curve.
    Linear,
}

impl Default for Image {
    /// 640 x 480, for a screen.
    fn default() -> Self {
        Self {
            width: 640,
            height: 480,
            transfer: Transfer::Srgb,
        }
    }
}

/// A camera: a pinhole, or a thin lens.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Position of the pinhole.
    pub eye: DVec3,
    /// The point in the middle of the picture.
    pub target: DVec3,
    /// Which way is up; need not be perpendicular to the line of sight.
    pub up: DVec3,
    /// Full vertical angle of view in degrees, between 0 and 180.
    pub fov_degrees: f64,
    /// Where in a pixel its ray goes through.
    pub sampling: PixelSampling,
    /// Diameter of the lens; 0 for a pinhole.
    pub aperture: f64,
    /// How far the plane is, along the line of sight, that the lens shows sharp; none for
    /// that of `target`.
    pub focus: Option<f64>,
    /// How far it moves while the shutter is open; it stands at its place in the middle of
    /// that time.
    pub velocity: DVec3,
}

impl Default for Camera {
    /// At the origin, looking along -z.
    fn default() -> Self {
        Self {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            fov_degrees: 60.0,
            sampling: PixelSampling::Center,
            aperture: 0.0,
            focus: None,
            velocity: DVec3::ZERO,
        }
    }
}

/// Where in a pixel its ray goes through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PixelSampling {
    /// The middle.
    Center,
    /// The lower left corner, as in the 2017 report.
    Corner,
}

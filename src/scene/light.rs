//! Lights.

use glam::DVec3;

use super::Rgb;

/// A light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Light {
    /// Light from one point.
    Point {
        /// Where it is.
        position: DVec3,
        /// Its colour, times its intensity.
        color: Rgb,
        /// How it weakens with distance.
        falloff: Falloff,
        /// Whether shapes keep it off others.
        shadow: bool,
    },
    /// Light from infinitely far away.
    Directional {
        /// Towards the light; any length but zero.
        direction: DVec3,
        /// Its colour, times its intensity.
        color: Rgb,
        /// Whether shapes keep it off others.
        shadow: bool,
    },
    /// A lamp with a size: it is seen, and its shadows are soft.
    Area {
        /// Its form.
        form: AreaForm,
        /// What it looks like from its front: radiance.
        radiance: Rgb,
    },
}

/// The form of a lamp with a size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AreaForm {
    /// A sphere that shines to all sides.
    Sphere {
        /// The middle.
        center: DVec3,
        /// Greater than 0.
        radius: f64,
    },
    /// A disk that shines to the side of its normal.
    Disk {
        /// The middle.
        center: DVec3,
        /// Any length but zero.
        normal: DVec3,
        /// Greater than 0.
        radius: f64,
    },
    /// A parallelogram that shines to the side of `right` x `up`.
    Rectangle {
        /// A corner.
        corner: DVec3,
        /// From there along one edge.
        right: DVec3,
        /// From there along the other edge.
        up: DVec3,
    },
}

/// How a point light weakens with distance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Falloff {
    /// Not at all.
    None,
    /// With the square of the distance.
    InverseSquare,
}

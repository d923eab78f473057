//! A picture, and how it came about.

use serde::Serialize;

use crate::bounds::Bounds;
use crate::count::Counters;
use crate::frame::Frame;
use crate::tier::Accuracy;

/// A picture and how it came about.
#[derive(Debug, Clone)]
pub struct Rendering {
    /// The picture.
    pub frame: Frame,
    /// How it came about.
    pub stats: Stats,
}

/// How a picture came about.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stats {
    /// `cpu` or `gpu`.
    pub backend: &'static str,
    /// The adapter's name; none on the CPU.
    pub adapter: Option<String>,
    /// The adapter's driver; none on the CPU.
    pub driver: Option<String>,
    /// In pixels.
    pub width: u32,
    /// In pixels.
    pub height: u32,
    /// Rays through a pixel.
    pub samples: u32,
    /// The estimated error of a picture of samples, see [`crate::samples::Taken::noise`].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub noise: Option<f64>,
    /// Samples that were no numbers, or took more steps than a driver allows, and are left out.
    #[serde(skip_serializing_if = "is_zero")]
    pub faults: u64,
    /// The first pixel that has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_fault: Option<[u32; 2]>,
    /// Formulas and width.
    pub accuracy: Accuracy,
    /// The bounding volumes in use.
    pub bounds: Bounds,
    /// What the scene calls for.
    pub effects: Vec<&'static str>,
    /// Spheres, planes, disks and triangles.
    pub primitives: u32,
    /// From the scene in memory to the picture in memory.
    pub seconds: f64,
    /// The part of it in which rays were traced, upload and download included.
    pub trace_ms: f64,
    /// The part of it in which the bounding volumes were built.
    pub build_ms: f64,
    /// Rays traced through pixels, those that they lead to not counted.
    pub rays: u64,
    /// Those of them that were in doubt and traced again, in the adaptive tier.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub retraced: Option<u64>,
    /// Million rays a second while tracing.
    pub mrays_per_s: f64,
    /// Bytes of the scene's arrays, as uploaded.
    pub device_bytes: u64,
    /// What the rays tested, where that was counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub counters: Option<Counters>,
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde asks for a reference"
)]
fn is_zero(number: &u64) -> bool {
    *number == 0
}

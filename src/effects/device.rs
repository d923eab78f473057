//! What a device brings to every shader, and what is asked of it.

use serde::Serialize;

use super::file;
use crate::gpu::program::Source;
use crate::tier::{Formulas, Width};

/// Division and square root as the device has them.
pub const DIVIDE_NATIVE: Source = file!("divide_native.wgsl");

/// Division and square root, corrected on a device that rounds them loosely.
pub const DIVIDE_CORRECTED: Source = file!("divide_corrected.wgsl");

/// How the shader reads the scene: from where a device reads it best.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Fetch {
    /// A storage buffer.
    Storage,
    /// A texture of four 32-bit numbers a texel.
    Texture,
    /// A uniform buffer, for small scenes.
    Uniform,
}

impl Fetch {
    /// Every way.
    pub const ALL: [Self; 3] = [Self::Storage, Self::Texture, Self::Uniform];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Storage => "storage buffer",
            Self::Texture => "texture",
            Self::Uniform => "uniform buffer",
        }
    }

    /// Its shader file.
    pub(crate) fn file(self) -> Source {
        match self {
            Self::Storage => file!("fetch_storage.wgsl"),
            Self::Texture => file!("fetch_texture.wgsl"),
            Self::Uniform => file!("fetch_uniform.wgsl"),
        }
    }
}

/// What a shader goes through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Entry {
    /// The pixels of a tile.
    Tile,
    /// A sample of each of them.
    Samples,
    /// Those of them whose rays are in doubt.
    DoubtfulPixels,
    /// The rays of a list.
    Rays,
    /// Those of them that are in doubt.
    DoubtfulRays,
    /// The paths of the rays of a list.
    Paths,
    /// Those of them that are in doubt.
    DoubtfulPaths,
}

impl Entry {
    /// What is gone through, and what is done with it.
    pub(super) fn files(self) -> [&'static [Source]; 2] {
        match self {
            Self::Tile => [ONE_RAY, const { &[file!("tile.wgsl")] }],
            Self::Samples => [PATHS_OF_LIGHT, const { &[file!("samples.wgsl")] }],
            Self::DoubtfulPixels => [
                &[],
                const { &[file!("retrace.wgsl"), file!("retrace_pixels.wgsl")] },
            ],
            Self::Rays => [SINGLE_RAYS, LIST],
            Self::DoubtfulRays => [SINGLE_RAYS, DOUBTFUL_LIST],
            Self::Paths => [PATHS, LIST],
            Self::DoubtfulPaths => [PATHS, DOUBTFUL_LIST],
        }
    }
}

/// A pixel by its one ray.
const ONE_RAY: &[Source] = &[file!("tile_order.wgsl")];

/// A pixel by paths of light.
const PATHS_OF_LIGHT: &[Source] = &[
    file!("tile_order.wgsl"),
    file!("integrator.wgsl"),
    file!("sources.wgsl"),
    file!("dimensions.wgsl"),
    file!("numbers.wgsl"),
    file!("layers.wgsl"),
    file!("tally.wgsl"),
    file!("frame.wgsl"),
    file!("circle.wgsl"),
];

/// Rays of a list that end where they meet something.
const SINGLE_RAYS: &[Source] = &[file!("rays.wgsl"), file!("single_rays.wgsl")];

/// Rays of a list that go on there.
const PATHS: &[Source] = &[
    file!("rays.wgsl"),
    file!("followed_rays.wgsl"),
    file!("path.wgsl"),
    file!("mirror.wgsl"),
    file!("refract.wgsl"),
];

/// All rays of a list.
const LIST: &[Source] = &[file!("trace_rays.wgsl")];

/// Those of them that are in doubt.
const DOUBTFUL_LIST: &[Source] = &[file!("retrace.wgsl"), file!("retrace_rays.wgsl")];

/// What a device brings to every shader, and what is asked of it.
#[derive(Debug, Clone, Copy)]
pub struct Device {
    /// Whether volumes are counted.
    pub count: bool,
    /// Which formulas.
    pub formulas: Formulas,
    /// In which numbers.
    pub width: Width,
    /// What is gone through.
    pub entry: Entry,
    /// Division and square root.
    pub divide: Source,
    /// Where the scene lies.
    pub fetch: Fetch,
}

//! The flags of `rayproof why`.

use std::path::PathBuf;

use clap::Args;

use crate::cli::tracing_flags::{
    BoundsChoice, PolicyFlags, chosen_bounds, parse_levels, parse_size,
};
use rayproof::bounds::Bounds;
use rayproof::error::Result;

#[derive(Debug, Args)]
pub(in crate::cli) struct WhyArguments {
    /// The scene file
    pub(super) scene: PathBuf,
    /// The pixel, counted from 0 at the left
    pub(super) x: u32,
    /// The pixel, counted from 0 at the top
    pub(super) y: u32,
    /// Size of the picture, in place of the scene's own
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub(super) size: Option<(u32, u32)>,
    /// Bounding volumes; they change what is tested, never the picture
    #[arg(long, value_enum, default_value_t = BoundsChoice::Tree)]
    bounds: BoundsChoice,
    /// Levels of spheres or boxes, those of the screen too
    #[arg(long, value_name = "N", value_parser = parse_levels)]
    levels: Option<u32>,
    #[command(flatten)]
    pub(super) policy: PolicyFlags,
}

impl WhyArguments {
    /// The volumes asked for.
    ///
    /// # Errors
    ///
    /// As [`chosen_bounds`].
    pub(super) fn bounds(&self) -> Result<Bounds> {
        chosen_bounds(self.bounds, self.levels)
    }
}

//! The flags of `rayproof plan`.

use std::path::PathBuf;

use clap::Args;

use crate::cli::effect_flags::EffectFlags;
use crate::cli::plan_flags::PlanFlags;
use crate::cli::tracing_flags::TracingFlags;

#[derive(Debug, Args)]
pub(in crate::cli) struct PlanArguments {
    /// The scene file
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) tracing: TracingFlags,
    #[command(flatten)]
    pub(super) effects: EffectFlags,
    /// Render the scene without each effect in turn, to tell what it costs; and with all
    /// effects in the shader, to prove that those left out change no bit
    #[arg(long)]
    pub(super) measure: bool,
    #[command(flatten)]
    pub(super) runs: PlanFlags,
}

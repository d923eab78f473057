//! The commands and their flags.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use super::accuracy::flags::AccuracyArguments;
use super::bench::flags::BenchArguments;
use super::effect_flags::EffectFlags;
use super::plan::flags::PlanArguments;
use super::shown::Shown;
use super::stability::flags::StabilityArguments;
use super::tracing_flags::{PlaceFlags, PolicyFlags, TracingFlags};
use super::until_flags::UntilFlags;
use super::why::flags::WhyArguments;
use rayproof::compare::Tolerance;
use rayproof::scene::mesh::{Builtin, MAX_DETAIL, MIN_DETAIL};

/// A headless ray tracer whose pictures can be trusted.
#[derive(Debug, Parser)]
#[command(name = "rayproof", version, about, max_term_width = 100)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub(super) command: Command,
    #[command(flatten)]
    pub(super) common: Common,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Render a scene to a PNG or EXR file
    Render(RenderArguments),
    /// Render a scene on GPU and CPU and compare, or compare two image files
    Compare(CompareArguments),
    /// Time bounding volumes and backends side by side, and compare their pictures
    Bench(BenchArguments),
    /// Measure what each accuracy tier costs, and how far it is from the exact answer
    Accuracy(AccuracyArguments),
    /// Try the hard cases of ray tracing in every accuracy tier on every adapter
    Stability(StabilityArguments),
    /// Say which effects a scene calls for and why, what is left out, and what each costs
    Plan(PlanArguments),
    /// Explain one pixel: what its ray meets in each accuracy tier and in truth, and why
    Why(WhyArguments),
    /// Check a scene and all that it refers to, and report every fault at once
    Check(CheckArguments),
    /// Show the adapters of this machine and what their arithmetic does
    Doctor,
    /// Write a built-in mesh as an OBJ file
    Mesh(MeshArguments),
}

/// Flags that every command takes.
#[derive(Debug, Args)]
pub(super) struct Common {
    /// Print one JSON object in place of a table
    #[arg(long, global = true)]
    pub(super) json: bool,
    /// When to show progress
    #[arg(long, global = true, value_enum, default_value_t = ProgressMode::Auto)]
    pub(super) progress: ProgressMode,
    /// Say nothing but errors
    #[arg(long, short, global = true)]
    pub(super) quiet: bool,
    /// Say more; twice for still more
    #[arg(long, short, global = true, action = clap::ArgAction::Count)]
    pub(super) verbose: u8,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ProgressMode {
    /// On a terminal, for work over a second
    Auto,
    /// A bar in any case
    Always,
    /// None
    Never,
    /// One JSON object a line, on standard error
    Json,
}

#[derive(Debug, Args)]
pub(super) struct RenderArguments {
    /// The scene file
    pub(super) scene: PathBuf,
    /// The picture to write, .png or .exr
    #[arg(long, short)]
    pub(super) output: PathBuf,
    #[command(flatten)]
    pub(super) tracing: TracingFlags,
    #[command(flatten)]
    pub(super) effects: EffectFlags,
    #[command(flatten)]
    pub(super) until: UntilFlags,
    /// What a pixel shows; for .exr several, or all layers of the picture if none is
    /// given. `tests` and `bounds` are heat maps of what its ray tests, the latter with
    /// the outlines of the volumes
    #[arg(long, value_name = "LAYER", value_delimiter = ',')]
    pub(super) layer: Vec<Shown>,
    /// Count the volumes and shapes that the rays test, in a pass of its own
    #[arg(long)]
    pub(super) count: bool,
    /// Write figures of the run as JSON to a file, or to standard output as `-`
    #[arg(long, value_name = "FILE")]
    pub(super) stats: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(super) struct CompareArguments {
    /// A scene file, or an image file
    pub(super) left: PathBuf,
    /// A second image file; or a second scene file, for the CPU in place of the first
    pub(super) right: Option<PathBuf>,
    /// Write a picture of the differences
    #[arg(long, short, value_name = "DIFF.png")]
    pub(super) output: Option<PathBuf>,
    #[command(flatten)]
    pub(super) place: PlaceFlags,
    #[command(flatten)]
    pub(super) effects: EffectFlags,
    /// Units in the last place by which a value may differ
    #[arg(long, value_name = "N")]
    pub(super) max_ulp: Option<u32>,
    /// Absolute difference by which a value may differ
    #[arg(long, value_name = "X")]
    pub(super) max_abs: Option<f64>,
    /// Pixels that may differ by more
    #[arg(long, value_name = "N")]
    pub(super) max_pixels: Option<u64>,
}

#[derive(Debug, Args)]
pub(super) struct CheckArguments {
    /// The scene file
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) policy: PolicyFlags,
}

#[derive(Debug, Args)]
#[command(after_help = meshes())]
pub(super) struct MeshArguments {
    /// The built-in mesh: teapot, icosphere, knot, terrain, box or tetrahedron
    #[arg(value_parser = parse_builtin)]
    pub(super) name: Builtin,
    /// The wished number of triangles, 4 to 10 million
    #[arg(long, value_name = "N",
          value_parser = clap::value_parser!(u32).range(i64::from(MIN_DETAIL)..=i64::from(MAX_DETAIL)))]
    pub(super) detail: Option<u32>,
    /// The OBJ file to write
    #[arg(long, short)]
    pub(super) output: PathBuf,
}

impl CompareArguments {
    /// What was asked for; where nothing was, `otherwise`.
    pub(super) fn tolerance(&self, otherwise: Tolerance) -> Tolerance {
        if self.max_ulp.is_none() && self.max_abs.is_none() && self.max_pixels.is_none() {
            return otherwise;
        }
        Tolerance {
            max_ulp: self.max_ulp.unwrap_or(0),
            max_abs: self.max_abs.unwrap_or(0.0),
            different_pixels: self.max_pixels.unwrap_or(0),
        }
    }
}

fn parse_builtin(text: &str) -> Result<Builtin, String> {
    Builtin::from_name(text).ok_or_else(|| {
        let names = Builtin::ALL.map(Builtin::name).join(", ");
        format!("there is no built-in mesh `{text}`; there are {names}")
    })
}

/// The built-in meshes, for `--help`.
fn meshes() -> String {
    let rows = Builtin::ALL.map(|mesh| format!("  {:12} {}\n", mesh.name(), mesh.describe()));
    format!("Meshes:\n{}", rows.concat())
}

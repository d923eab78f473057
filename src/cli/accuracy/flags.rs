//! The flags of `rayproof accuracy`, and their conversion into checked options.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::cli::bench::flags::BenchBackend;
use crate::cli::plan_flags::PlanFlags;
use crate::cli::tracing_flags::{AccuracyChoice, PolicyFlags, parse_size, parse_threads, tiers_of};
use rayproof::accuracy::Hazard;
use rayproof::bounds::Bounds;
use rayproof::error::{Error, Result};
use rayproof::gpu::device::Gpu;
use rayproof::measure::Plan;
use rayproof::render::{Accuracy, Backend};
use rayproof::scene::Scene;

#[derive(Debug, Args)]
pub(in crate::cli) struct AccuracyArguments {
    /// The scene file
    pub(super) scene: PathBuf,
    /// Make the scene harder step by step
    #[arg(long, value_enum)]
    hazard: Option<HazardChoice>,
    /// Tiers, side by side; all of them if not given
    #[arg(long, value_enum, value_name = "LIST", value_delimiter = ',')]
    tier: Vec<AccuracyChoice>,
    /// What traces the rays
    #[arg(long, value_enum, default_value_t = BenchBackend::All)]
    backend: BenchBackend,
    /// The GPU adapter whose name, driver or backend contains this
    #[arg(long, value_name = "SUBSTRING")]
    adapter: Option<String>,
    /// Threads of the CPU path; one for each core if not given
    #[arg(long, value_name = "N", value_parser = parse_threads)]
    threads: Option<NonZeroUsize>,
    /// Bounding volumes
    #[arg(long, value_enum, default_value_t = BoundsOfRays::Tree)]
    bounds: BoundsOfRays,
    /// Size of the picture, in place of the scene's own
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<(u32, u32)>,
    #[command(flatten)]
    plan: PlanFlags,
    /// Write a plot of error against time (.svg), or with `--layer` a picture of one tier's
    /// errors (.png)
    #[arg(long, short, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
    /// What the picture shows
    #[arg(long, value_enum, requires = "output")]
    layer: Option<ErrorLayer>,
    #[command(flatten)]
    policy: PolicyFlags,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum HazardChoice {
    /// The camera moves away, to 10 million radii of the scene, and its view narrows
    Distance,
    /// Scene and camera move away from the origin
    Offset,
    /// Scene and camera are scaled, from 1e-6 to 1e6
    Scale,
    /// Each triangle is cut in two, one of them up to a million times thinner
    Slivers,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum BoundsOfRays {
    /// A bounding volume hierarchy
    Tree,
    /// Brute force
    None,
}

/// What a picture of errors shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ErrorLayer {
    /// By how many ulp of f32 each ray's t is off
    Ulp,
    /// The rays that miss what they should hit, or hit what they should not
    Wrong,
}

/// What is to be written.
pub(super) enum Written<'a> {
    Nothing,
    Plot(&'a Path),
    Picture(&'a Path, ErrorLayer),
}

impl AccuracyArguments {
    pub(super) fn hazard(&self) -> Option<Hazard> {
        Some(match self.hazard? {
            HazardChoice::Distance => Hazard::Distance,
            HazardChoice::Offset => Hazard::Offset,
            HazardChoice::Scale => Hazard::Scale,
            HazardChoice::Slivers => Hazard::Slivers,
        })
    }

    /// The tiers to measure, each once.
    pub(super) fn tiers(&self) -> Vec<Accuracy> {
        tiers_of(&self.tier)
    }

    pub(super) fn bounds(&self) -> Bounds {
        match self.bounds {
            BoundsOfRays::Tree => Bounds::Tree,
            BoundsOfRays::None => Bounds::None,
        }
    }

    pub(super) fn plan(&self) -> Plan {
        self.plan.plan()
    }

    /// What is to be written, by the file's ending.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] where ending and flags do not go together.
    pub(super) fn written(&self) -> Result<Written<'_>> {
        let Some(path) = &self.output else {
            return Ok(Written::Nothing);
        };
        let ending = path.extension().and_then(|ending| ending.to_str());
        match (ending, self.layer) {
            (Some("svg"), None) => Ok(Written::Plot(path)),
            (Some("png"), Some(_)) if self.hazard.is_some() || self.tiers().len() != 1 => {
                Err(Error::Usage(
                    "a picture of errors is of one tier, without a hazard: add `--tier robust`"
                        .into(),
                ))
            }
            (Some("png"), Some(layer)) => Ok(Written::Picture(path, layer)),
            (Some("svg"), Some(_)) => Err(Error::Usage(
                "`--layer` writes a picture: name a .png file".into(),
            )),
            (Some("png"), None) => Err(Error::Usage(
                "a .png shows the errors of each pixel: add `--layer ulp` or `--layer wrong`"
                    .into(),
            )),
            _ => Err(Error::Usage(format!(
                "`{}` is neither a plot (.svg) nor a picture (.png)",
                path.display()
            ))),
        }
    }

    /// What is to trace the rays.
    ///
    /// # Errors
    ///
    /// [`Error::NoAdapter`] where a GPU is demanded and there is none.
    pub(super) fn backends(&self) -> Result<Vec<Backend>> {
        let cpu = || Backend::Cpu(self.threads);
        let gpu = || Gpu::open(self.adapter.as_deref()).map(|gpu| Backend::Gpu(Box::new(gpu)));
        match self.backend {
            BenchBackend::Cpu if self.adapter.is_some() => Err(Error::Usage(
                "`--adapter` names a GPU, `--backend cpu` needs none".into(),
            )),
            BenchBackend::Cpu => Ok(vec![cpu()]),
            BenchBackend::Gpu => Ok(vec![gpu()?]),
            BenchBackend::All => Ok(vec![cpu(), gpu()?]),
            BenchBackend::Auto => match gpu() {
                Err(Error::NoAdapter(reason)) if self.adapter.is_none() => {
                    tracing::warn!("no GPU adapter: {reason}; measuring the CPU");
                    Ok(vec![cpu()])
                }
                outcome => Ok(vec![outcome?]),
            },
        }
    }

    /// Loads the scene, in the size asked for.
    ///
    /// # Errors
    ///
    /// All the faults of the scene.
    pub(super) fn load(&self) -> Result<Scene> {
        self.policy.load_scene(&self.scene, self.size)
    }
}

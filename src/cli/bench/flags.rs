//! The flags of `rayproof bench`, and their conversion into checked options.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::cli::plan_flags::PlanFlags;
use crate::cli::tracing_flags::{
    BoundsChoice, ONE_LEVEL, PolicyFlags, parse_levels, parse_size, parse_threads,
};
use rayproof::bounds::Bounds;
use rayproof::error::{Error, Result};
use rayproof::gpu::device::Gpu;
use rayproof::measure::Plan;
use rayproof::scene::Scene;
use rayproof::scene::mesh::MAX_DETAIL;

/// Triangles of the knots that are measured unless others are named.
const SIZES: [u32; 5] = [1_000, 11_000, 100_000, 1_000_000, 10_000_000];

#[derive(Debug, Args)]
pub(in crate::cli) struct BenchArguments {
    /// The scene file
    #[arg(required_unless_present = "scale", conflicts_with = "scale")]
    scene: Option<PathBuf>,
    /// In place of a scene, knots of so many triangles, 1,000 to 10 million if not given:
    /// how times and memory grow
    #[arg(long, value_name = "LIST", num_args = 0.., value_delimiter = ',',
          value_parser = clap::value_parser!(u32).range(1..=MAX_DETAIL as i64),
          conflicts_with_all = ["bounds", "levels", "count"])]
    scale: Option<Vec<u32>>,
    #[command(flatten)]
    plan: PlanFlags,
    /// Size of the picture, in place of the scene's own
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<(u32, u32)>,
    /// What traces the rays
    #[arg(long, value_enum, default_value_t = BenchBackend::All)]
    backend: BenchBackend,
    /// Bounding volumes, side by side; all of them if not given
    #[arg(long, value_enum, value_name = "LIST", value_delimiter = ',')]
    bounds: Vec<BoundsChoice>,
    /// Levels of spheres or boxes, those of the screen too
    #[arg(long, value_name = "N", default_value_t = ONE_LEVEL, value_parser = parse_levels)]
    levels: u32,
    /// Count what the rays test, in a run of its own
    #[arg(long)]
    pub(super) count: bool,
    /// Numbers of threads of the CPU path, side by side; one for each core if not given
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_threads)]
    threads: Vec<NonZeroUsize>,
    /// The GPU adapter whose name, driver or backend contains this
    #[arg(long, value_name = "SUBSTRING")]
    adapter: Option<String>,
    #[command(flatten)]
    policy: PolicyFlags,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum BenchBackend {
    /// The best GPU adapter, software Vulkan included, or else the CPU
    Auto,
    /// The CPU reference path
    Cpu,
    /// A GPU adapter
    Gpu,
    /// The CPU reference path and a GPU adapter
    All,
}

impl BenchArguments {
    /// The sizes of the knots to measure in place of a scene, from the smallest.
    pub(super) fn sizes(&self) -> Option<Vec<u32>> {
        let mut sizes = self.scale.clone()?;
        if sizes.is_empty() {
            sizes = SIZES.to_vec();
        }
        sizes.sort_unstable();
        sizes.dedup();
        Some(sizes)
    }

    /// Width and height of the knots' pictures.
    pub(super) fn knot_size(&self) -> (u32, u32) {
        self.size.unwrap_or((1000, 1000))
    }

    /// How often to run.
    pub(super) fn plan(&self) -> Plan {
        self.plan.plan()
    }

    /// The volumes to measure.
    pub(super) fn bounds(&self) -> Vec<Bounds> {
        let all = BoundsChoice::value_variants();
        let chosen = if self.bounds.is_empty() {
            all
        } else {
            &self.bounds
        };
        let levels = self.levels;
        chosen.iter().map(|choice| choice.bounds(levels)).collect()
    }

    /// Opens the GPU adapter, where one is to be measured.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] for flags of a backend that is not measured,
    /// [`Error::NoAdapter`] where a GPU is demanded and there is none.
    pub(super) fn open_gpu(&self) -> Result<Option<Gpu>> {
        match self.backend {
            BenchBackend::Cpu if self.adapter.is_some() => Err(Error::Usage(
                "`--adapter` names a GPU, `--backend cpu` needs none".into(),
            )),
            BenchBackend::Gpu if !self.threads.is_empty() => Err(Error::Usage(
                "`--threads` is for the CPU, which `--backend gpu` leaves out".into(),
            )),
            BenchBackend::Cpu => Ok(None),
            BenchBackend::Gpu | BenchBackend::All => Gpu::open(self.adapter.as_deref()).map(Some),
            BenchBackend::Auto => match Gpu::open(self.adapter.as_deref()) {
                Err(Error::NoAdapter(reason)) if self.adapter.is_none() => {
                    tracing::warn!("no GPU adapter: {reason}; measuring the CPU");
                    Ok(None)
                }
                outcome => outcome.map(Some),
            },
        }
    }

    /// The numbers of threads to measure the CPU with, none being one for each
    /// core; empty where the CPU is not to be measured.
    pub(super) fn threads(&self, gpu: Option<&Gpu>) -> Vec<Option<NonZeroUsize>> {
        let on_cpu = match self.backend {
            BenchBackend::Cpu | BenchBackend::All => true,
            BenchBackend::Gpu => false,
            BenchBackend::Auto => gpu.is_none(),
        };
        match (on_cpu, self.threads.as_slice()) {
            (false, _) => Vec::new(),
            (true, []) => vec![None],
            (true, threads) => threads.iter().copied().map(Some).collect(),
        }
    }

    /// The scene file; clap sees to it that there is one, or `--scale`.
    pub(super) fn scene(&self) -> &Path {
        self.scene.as_deref().unwrap_or(Path::new(""))
    }

    /// Loads the scene, in the size asked for.
    ///
    /// # Errors
    ///
    /// All the faults of the scene.
    pub(super) fn load(&self) -> Result<Scene> {
        self.policy.load_scene(self.scene(), self.size)
    }
}

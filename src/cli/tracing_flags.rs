//! The flags that say where, how and of which files pictures are traced.

use std::num::NonZeroUsize;
use std::path::Path;

use clap::{Args, ValueEnum};

use rayproof::bounds::{Bounds, MAX_LEVELS};
use rayproof::cpu::MAX_THREADS;
use rayproof::error::{Error, Result};
use rayproof::gpu::device::Gpu;
use rayproof::render::{Accuracy, Backend, Settings};
use rayproof::scene::Scene;
use rayproof::scene::parse::{self, Loaded};
use rayproof::scene::policy::Policy;

#[derive(Debug, Args)]
pub(super) struct TracingFlags {
    /// What traces the rays
    #[arg(long, value_enum, default_value_t = BackendChoice::Auto)]
    pub(super) backend: BackendChoice,
    #[command(flatten)]
    pub(super) place: PlaceFlags,
    /// Formulas and width of the geometry
    #[arg(long, value_enum, default_value_t = AccuracyChoice::Robust)]
    pub(super) accuracy: AccuracyChoice,
}

#[derive(Debug, Args)]
pub(super) struct PlaceFlags {
    /// The GPU adapter whose name, driver or backend contains this
    #[arg(long, value_name = "SUBSTRING")]
    pub(super) adapter: Option<String>,
    /// Size of the picture, in place of the scene's own
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub(super) size: Option<(u32, u32)>,
    /// Threads of the CPU path; one for each core if not given
    #[arg(long, value_name = "N", value_parser = parse_threads)]
    pub(super) threads: Option<NonZeroUsize>,
    /// Bounding volumes; they change the time, never the picture
    #[arg(long, value_enum, default_value_t = BoundsChoice::Tree)]
    pub(super) bounds: BoundsChoice,
    /// Levels of spheres or boxes, those of the screen too: 1 for one around each group
    /// and mesh, 2 for four more in each, and so on
    #[arg(long, value_name = "N", value_parser = parse_levels)]
    pub(super) levels: Option<u32>,
    #[command(flatten)]
    pub(super) policy: PolicyFlags,
}

#[derive(Debug, Args)]
pub(super) struct PolicyFlags {
    /// Let the scene refer to files outside its folder
    #[arg(long)]
    pub(super) allow_outside: bool,
    /// Take dropped faces and the like for errors
    #[arg(long)]
    pub(super) strict: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum BackendChoice {
    /// The best GPU adapter, software Vulkan included, or else the CPU
    Auto,
    /// A GPU adapter
    Gpu,
    /// The CPU reference path
    Cpu,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum BoundsChoice {
    /// Brute force: every ray tests every primitive
    None,
    /// The volumes of the scene's groups, as the scene file gives them
    Scene,
    /// A tight sphere around each group and mesh, and more in it with `--levels`
    Spheres,
    /// An axis-aligned box around each group and mesh, and more in it with `--levels`
    Boxes,
    /// The spheres, sorted to tiles of the screen beforehand
    Screen,
    /// A bounding volume hierarchy
    Tree,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum AccuracyChoice {
    /// The formulas of a textbook, in f32
    Textbook,
    /// Stable formulas in f32
    Robust,
    /// Stable formulas in two f32
    Extended,
    /// Stable formulas in f64, scene and rays unrounded
    Double,
    /// Stable formulas in f32, and rays in doubt once more in f64
    Adaptive,
}

impl TracingFlags {
    /// Opens what is to trace the rays, and says so where `auto` chose.
    ///
    /// # Errors
    ///
    /// [`Error::NoAdapter`] where a GPU is demanded and there is none.
    pub(super) fn open_backend(&self) -> Result<Backend> {
        let threads = self.place.threads;
        match self.backend {
            BackendChoice::Cpu if self.place.adapter.is_some() => Err(Error::Usage(
                "`--adapter` names a GPU, `--backend cpu` needs none".into(),
            )),
            BackendChoice::Cpu => Ok(Backend::Cpu(threads)),
            BackendChoice::Gpu => Ok(Backend::Gpu(Box::new(self.place.open_gpu()?))),
            BackendChoice::Auto => match self.place.open_gpu() {
                Ok(gpu) => match gpu.lacks(self.accuracy()) {
                    None => Ok(Backend::Gpu(Box::new(gpu))),
                    Some(reason) => {
                        tracing::warn!("{reason}; rendering on the CPU");
                        Ok(Backend::Cpu(threads))
                    }
                },
                Err(Error::NoAdapter(reason)) if self.place.adapter.is_none() => {
                    tracing::warn!("no GPU adapter: {reason}; rendering on the CPU");
                    Ok(Backend::Cpu(threads))
                }
                Err(error) => Err(error),
            },
        }
    }

    /// How to render.
    ///
    /// # Errors
    ///
    /// As [`PlaceFlags::bounds`].
    pub(super) fn settings(&self) -> Result<Settings> {
        Ok(Settings {
            accuracy: self.accuracy(),
            bounds: self.place.bounds()?,
            forced: rayproof::effects::EffectSet::NONE,
        })
    }

    /// The accuracy asked for.
    pub(super) fn accuracy(&self) -> Accuracy {
        self.accuracy.accuracy()
    }
}

impl AccuracyChoice {
    /// The tier that it names.
    pub(super) fn accuracy(self) -> Accuracy {
        match self {
            Self::Textbook => Accuracy::Textbook,
            Self::Robust => Accuracy::Robust,
            Self::Extended => Accuracy::Extended,
            Self::Double => Accuracy::Double,
            Self::Adaptive => Accuracy::Adaptive,
        }
    }
}

/// The tiers that a list names, each once; all of them if it is empty.
pub(super) fn tiers_of(choices: &[AccuracyChoice]) -> Vec<Accuracy> {
    if choices.is_empty() {
        return Accuracy::ALL.to_vec();
    }
    let mut tiers: Vec<_> = choices.iter().map(|choice| choice.accuracy()).collect();
    tiers.sort();
    tiers.dedup();
    tiers
}

/// Levels where `--levels` is not given.
pub(super) const ONE_LEVEL: u32 = 1;

impl BoundsChoice {
    /// The volumes that it names, so many levels deep where they have levels.
    pub(super) fn bounds(self, levels: u32) -> Bounds {
        match self {
            Self::None => Bounds::None,
            Self::Scene => Bounds::Scene,
            Self::Spheres => Bounds::Spheres { levels },
            Self::Boxes => Bounds::Boxes { levels },
            Self::Screen => Bounds::Screen { levels },
            Self::Tree => Bounds::Tree,
        }
    }
}

/// The volumes of `--bounds` and `--levels`.
///
/// # Errors
///
/// [`Error::Usage`] for levels of volumes that have none.
pub(super) fn chosen_bounds(choice: BoundsChoice, levels: Option<u32>) -> Result<Bounds> {
    let bounds = choice.bounds(levels.unwrap_or(ONE_LEVEL));
    match bounds {
        Bounds::None | Bounds::Scene | Bounds::Tree if levels.is_some() => Err(Error::Usage(
            "`--levels` goes with `--bounds spheres`, `boxes` or `screen`".into(),
        )),
        _ => Ok(bounds),
    }
}

pub(super) fn parse_levels(text: &str) -> Result<u32, String> {
    match text.parse() {
        Ok(levels) if (1..=MAX_LEVELS).contains(&levels) => Ok(levels),
        _ => Err(format!("`{text}` is not a number from 1 to {MAX_LEVELS}")),
    }
}

impl PlaceFlags {
    /// The volumes asked for.
    ///
    /// # Errors
    ///
    /// As [`chosen_bounds`].
    pub(super) fn bounds(&self) -> Result<Bounds> {
        chosen_bounds(self.bounds, self.levels)
    }

    /// Opens the GPU adapter asked for.
    ///
    /// # Errors
    ///
    /// [`Error::NoAdapter`] where there is none.
    pub(super) fn open_gpu(&self) -> Result<Gpu> {
        Gpu::open(self.adapter.as_deref())
    }

    /// Loads a scene, in the size asked for.
    ///
    /// # Errors
    ///
    /// All the faults of the scene.
    pub(super) fn load(&self, path: &Path) -> Result<Scene> {
        self.policy.load_scene(path, self.size)
    }
}

impl PolicyFlags {
    /// Loads a scene, in the size asked for, and logs its warnings.
    ///
    /// # Errors
    ///
    /// All the faults of the scene.
    pub(super) fn load_scene(&self, path: &Path, size: Option<(u32, u32)>) -> Result<Scene> {
        let Loaded {
            scene, warnings, ..
        } = self.load(path)?;
        for warning in warnings {
            tracing::warn!("{warning}");
        }
        Ok(match size {
            Some((width, height)) => scene.with_size(width, height),
            None => scene,
        })
    }

    /// Loads a scene and keeps its warnings.
    ///
    /// # Errors
    ///
    /// All the faults of the scene.
    pub(super) fn load(&self, path: &Path) -> Result<Loaded> {
        let policy = Policy {
            allow_outside: self.allow_outside,
            strict: self.strict,
            ..Policy::default()
        };
        parse::load(path, &policy)
    }
}

pub(super) fn parse_size(text: &str) -> Result<(u32, u32), String> {
    let wrong = || format!("`{text}` is not a size; write it as 640x480");
    let (width, height) = text.split_once(['x', 'X']).ok_or_else(wrong)?;
    let size = (
        width.parse().map_err(|_| wrong())?,
        height.parse().map_err(|_| wrong())?,
    );
    let most = rayproof::scene::MAX_IMAGE_SIDE as u32;
    if size.0 == 0 || size.1 == 0 || size.0 > most || size.1 > most {
        return Err(format!("each side of `{text}` must be 1 to {most} pixels"));
    }
    Ok(size)
}

pub(super) fn parse_threads(text: &str) -> Result<NonZeroUsize, String> {
    match text.parse() {
        Ok(threads) if NonZeroUsize::get(threads) <= MAX_THREADS => Ok(threads),
        _ => Err(format!("`{text}` is not a number from 1 to {MAX_THREADS}")),
    }
}

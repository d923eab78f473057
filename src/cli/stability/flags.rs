//! The flags of `rayproof stability`, and their conversion into checked options.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::cli::tracing_flags::{AccuracyChoice, parse_threads, tiers_of};
use rayproof::error::{Error, Result};
use rayproof::gpu::adapter::adapters;
use rayproof::gpu::device::Gpu;
use rayproof::render::{Accuracy, Backend};
use rayproof::stability::view::{VIEWS, View, view_of};
use rayproof::stability::{Case, FAMILIES, catalogue};

/// What `--thorough` multiplies the rays by.
const THOROUGH: u32 = 100;

#[derive(Debug, Args)]
pub(in crate::cli) struct StabilityArguments {
    /// Cases, by their ids or the family that these begin with; all of them if not given
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    case: Vec<String>,
    /// Tiers, side by side; all of them if not given
    #[arg(long, value_enum, value_name = "LIST", value_delimiter = ',')]
    tier: Vec<AccuracyChoice>,
    /// What traces the rays
    #[arg(long, value_enum, default_value_t = StabilityBackend::All)]
    backend: StabilityBackend,
    /// The GPU adapter whose name, driver or backend contains this
    #[arg(long, value_name = "SUBSTRING")]
    adapter: Option<String>,
    /// Threads of the CPU path; one for each core if not given
    #[arg(long, value_name = "N", value_parser = parse_threads)]
    threads: Option<NonZeroUsize>,
    /// Try 100 times as many rays
    #[arg(long)]
    thorough: bool,
    /// Tell what the cases are, and try none
    #[arg(long)]
    pub(super) list: bool,
    /// In place of trying a case that can be seen, write a picture of it (.png): each tier's
    /// wrong pixels in colour, the tiers side by side
    #[arg(
        long,
        short,
        value_name = "FILE",
        requires = "case",
        conflicts_with = "list"
    )]
    output: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum StabilityBackend {
    /// The CPU reference path
    Cpu,
    /// Every GPU adapter, software Vulkan included, or the one that is named
    Gpu,
    /// The CPU reference path and every GPU adapter
    All,
}

impl StabilityArguments {
    /// The cases to try, in the order of the catalogue.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] where a name fits none.
    pub(super) fn cases(&self) -> Result<Vec<&'static Case>> {
        let fits = |case: &Case, name: &String| {
            let rest = case.id.strip_prefix(name.as_str());
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
        };
        for name in &self.case {
            if !catalogue().any(|case| fits(case, name)) {
                return Err(unknown(name));
            }
        }
        let is_wanted =
            |case: &&Case| self.case.is_empty() || self.case.iter().any(|name| fits(case, name));
        Ok(catalogue().filter(is_wanted).collect())
    }

    /// Where to write a picture, and of which case.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] where there is no picture of what is asked for.
    pub(super) fn view(&self) -> Result<Option<(&Path, &'static View)>> {
        let Some(path) = &self.output else {
            return Ok(None);
        };
        if path.extension().is_none_or(|ending| ending != "png") {
            let path = path.display();
            return Err(Error::Usage(format!("`{path}` is not a picture (.png)")));
        }
        let view = match self.case.as_slice() {
            [id] => view_of(id),
            _ => None,
        };
        view.map(|view| Some((path.as_path(), view)))
            .ok_or_else(|| {
                let ids: Vec<&str> = VIEWS.iter().map(|view| view.id).collect();
                Error::Usage(format!(
                    "a picture shows one case, and these can be seen: {}",
                    ids.join(", ")
                ))
            })
    }

    /// The tiers to try, each once.
    pub(super) fn tiers(&self) -> Vec<Accuracy> {
        tiers_of(&self.tier)
    }

    /// How often each case is tried, each time with other rays.
    pub(super) fn rounds(&self) -> u32 {
        if self.thorough { THOROUGH } else { 1 }
    }

    /// What is to trace the rays.
    ///
    /// # Errors
    ///
    /// [`Error::NoAdapter`] where a GPU is asked for and there is none; that of an adapter
    /// which does not open.
    pub(super) fn backends(&self) -> Result<Vec<Backend>> {
        let mut backends = Vec::new();
        if self.backend != StabilityBackend::Gpu {
            backends.push(Backend::Cpu(self.threads));
        }
        match (self.backend, &self.adapter) {
            (StabilityBackend::Cpu, Some(_)) => {
                return Err(Error::Usage(
                    "`--adapter` names a GPU, `--backend cpu` needs none".into(),
                ));
            }
            (StabilityBackend::Cpu, None) => {}
            (_, Some(_)) => backends.push(gpu(Gpu::open(self.adapter.as_deref())?)),
            (_, None) => {
                let before = backends.len();
                for adapter in adapters() {
                    // OpenGL only where it is named.
                    if adapter.get_info().backend != wgpu::Backend::Gl {
                        backends.push(gpu(Gpu::open_adapter(&adapter, None)?));
                    }
                }
                if backends.len() == before {
                    return Err(Error::NoAdapter(
                        "this machine offers none; `--backend cpu` does without".into(),
                    ));
                }
            }
        }
        Ok(backends)
    }
}

fn gpu(gpu: Gpu) -> Backend {
    Backend::Gpu(Box::new(gpu))
}

/// There is no such case; what there is instead.
fn unknown(name: &str) -> Error {
    let family = name.split('/').next().unwrap_or_default();
    let of_family = catalogue().filter(|case| case.id.split('/').next() == Some(family));
    let ids: Vec<&str> = of_family.map(|case| case.id).collect();
    let known = if ids.is_empty() {
        FAMILIES.iter().map(|family| family.name).collect()
    } else {
        ids
    };
    Error::Usage(format!(
        "there is no hard case `{name}`; there are {}",
        known.join(", ")
    ))
}

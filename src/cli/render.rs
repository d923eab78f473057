//! `rayproof render`.

use std::ffi::OsStr;
use std::path::Path;

use serde::Serialize;

use super::Outcome;
use super::flags::{Common, RenderArguments};
use super::paths::{warn_of_faults, warn_of_paths};
use super::progress::Progress;
use super::report::{self, table};
use super::shown::{Shown, Written, one_layer_of};
use rayproof::count::{COUNT_BYTES, CountMap};
use rayproof::error::{Error, Result};
use rayproof::frame::{self, Frame};
use rayproof::render::{Rendering, Settings, Stats, Until, count, render_until};
use rayproof::samples::Preview;

/// The kinds of picture that can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Png,
    Exr,
}

impl Format {
    /// Bytes a pixel that writing takes.
    fn packing(self) -> u64 {
        match self {
            Self::Png => frame::PNG_PACKING,
            Self::Exr => frame::EXR_PACKING,
        }
    }
}

/// The figures of a run, with the scene's name.
#[derive(Serialize)]
struct Figures<'a> {
    scene: String,
    #[serde(flatten)]
    stats: &'a Stats,
}

/// Renders a scene to a file. Whatever can be known to go wrong is found out
/// before the first ray.
pub(super) fn run(arguments: &RenderArguments, common: &Common) -> Result<Outcome> {
    let format = format_of(&arguments.output)?;
    let shown = shown_by(arguments, format)?;
    frame::check_writable(&arguments.output)?;
    let stats_file = arguments
        .stats
        .as_deref()
        .filter(|path| *path != Path::new("-"));
    if let Some(path) = stats_file {
        frame::check_writable(path)?;
    }
    let scene = arguments.tracing.place.load(&arguments.scene)?;
    let (until, effects) = (&arguments.until, &arguments.effects);
    let scene = until.change(effects.change(scene)?, effects.samples);
    let counts = arguments.count || shown.iter().any(|shown| shown.is_counted());
    if counts {
        warn_of_paths(&scene, "counted is what is tested by");
    }
    let counting = if counts { COUNT_BYTES } else { 0 };
    let (width, height) = (scene.image.width, scene.image.height);
    Frame::check_memory(width, height, format.packing() + counting)?;
    let settings = Settings {
        forced: effects.forced()?,
        ..arguments.tracing.settings()?
    };
    let backend = arguments.tracing.open_backend()?;
    tracing::info!("rendering on {}", backend.describe());

    let progress = Progress::new(common, format!("{}", arguments.scene.display()));
    let mut preview = |frame: &Frame, samples: u32| {
        tracing::info!("{samples} samples so far");
        let written = Written {
            scene: &scene,
            settings,
            frame,
            counted: &CountMap::default(),
        };
        written.write(format, &arguments.output, &shown)
    };
    // Counts are there only when the picture is done.
    let may_preview = !shown.iter().any(|shown| shown.is_counted());
    let every = until.preview_every().filter(|_| may_preview);
    let until = Until {
        enough: until.enough(),
        preview: every.map(|every| Preview {
            every,
            show: &mut preview,
        }),
    };
    let mut rendering = render_until(&scene, &backend, settings, &progress, until)?;
    drop(progress);
    // Without volumes, where some rays met too many.
    let settings = Settings {
        bounds: rendering.stats.bounds,
        ..settings
    };
    let mut counted = CountMap::default();
    if counts {
        let progress = Progress::new(common, "counting");
        counted = count(&scene, &backend, settings, &progress)?;
        rendering.stats.counters = Some(counted.sum());
    }
    let broken = rendering.frame.non_finite_pixels();
    if broken > 0 {
        tracing::warn!("{broken} pixels have a colour that is infinite or not a number");
    }
    let written = Written {
        scene: &scene,
        settings,
        frame: &rendering.frame,
        counted: &counted,
    };
    written.write(format, &arguments.output, &shown)?;
    warn_of_faults(&rendering.stats);

    let figures = Figures {
        scene: arguments.scene.display().to_string(),
        stats: &rendering.stats,
    };
    let json = report::json(&figures);
    if let Some(path) = stats_file {
        frame::write_atomically(path, json.as_bytes())?;
    }
    if common.json || arguments.stats.is_some() && stats_file.is_none() {
        report::print(&json)?;
    } else if !common.quiet {
        report::print(&summary(&rendering, arguments, &backend.describe()))?;
    }
    Ok(Outcome::Done)
}

impl Written<'_> {
    fn write(&self, format: Format, output: &Path, shown: &[Shown]) -> Result<()> {
        match format {
            Format::Png => self.write_png(output, shown[0], self.scene.image.transfer),
            Format::Exr => self.write_exr(output, shown),
        }
    }
}

fn format_of(path: &Path) -> Result<Format> {
    let extension = path.extension().and_then(OsStr::to_str).unwrap_or_default();
    if extension.eq_ignore_ascii_case("png") {
        return Ok(Format::Png);
    }
    if extension.eq_ignore_ascii_case("exr") {
        return Ok(Format::Exr);
    }
    Err(Error::Usage(format!(
        "`{}` ends neither in .png nor in .exr: the ending says what to write",
        path.display()
    )))
}

fn shown_by(arguments: &RenderArguments, format: Format) -> Result<Vec<Shown>> {
    match (format, arguments.layer.as_slice()) {
        (Format::Png, shown) => one_layer_of(shown).map(|shown| vec![shown]),
        (Format::Exr, []) => Ok(Shown::all_layers()),
        (Format::Exr, shown) => Ok(shown.to_vec()),
    }
}

fn summary(rendering: &Rendering, arguments: &RenderArguments, backend: &str) -> String {
    let stats = &rendering.stats;
    let mut rows = vec![
        ("scene", arguments.scene.display().to_string()),
        (
            "picture",
            format!(
                "{} ({} x {})",
                arguments.output.display(),
                stats.width,
                stats.height
            ),
        ),
        ("backend", backend.to_string()),
        ("primitives", stats.primitives.to_string()),
        ("effects", stats.effects.join(", ")),
        (
            "time",
            format!(
                "{:.0} ms traced, {:.2} M rays/s",
                stats.trace_ms, stats.mrays_per_s
            ),
        ),
    ];
    if stats.samples > 1 {
        let noise = stats.noise.map_or(String::new(), |noise| {
            format!(", {:.2} % noise", 100.0 * noise)
        });
        rows.push(("samples", format!("{} a pixel{noise}", stats.samples)));
    }
    if let Some(counters) = stats.counters {
        let tested = format!(
            "{} met of {} tested",
            counters.bound_hits, counters.bound_tests
        );
        rows.push(("volumes", tested));
        rows.push(("shapes", format!("{} tested", counters.shape_tests)));
    }
    table(&rows)
}

//! `rayproof compare`.

use std::path::Path;

use super::Outcome;
use super::flags::{Common, CompareArguments};
use super::paths::warn_of_faults;
use super::progress::Progress;
use super::report::{self, table};
use rayproof::compare::{
    Comparison, DifferenceMap, LayerDifference, Tolerance, compare_frames, compare_pictures,
    difference_of_frames, difference_of_pictures,
};
use rayproof::error::{Error, Result};
use rayproof::frame::{self, read_image};
use rayproof::render::{Backend, Settings, render};
use rayproof::scene::Image;

/// What a device is held to that may contract or reorder sums, where the
/// scene's picture is not expected to be bit-identical. Contraction moves each
/// of the some 60 roundings between a pixel and its colour by an ulp at most, and
/// the hit point's error is amplified by distance over radius: 2^12 ulp allows
/// for a ratio of 64. At silhouettes a ray may fall to the other side.
const INEXACT: Tolerance = Tolerance {
    max_ulp: 1 << 12,
    max_abs: 0.0,
    different_pixels: 0,
};

/// The part of all pixels, in thousandths, that may lie on such silhouettes.
const INEXACT_OUTLIERS: u64 = 1;

/// Compares a scene on GPU and CPU, or two image files.
pub(super) fn run(arguments: &CompareArguments, common: &Common) -> Result<Outcome> {
    if let Some(output) = &arguments.output {
        if !output
            .extension()
            .is_some_and(|ending| ending.eq_ignore_ascii_case("png"))
        {
            return Err(Error::Usage(format!(
                "`{}` does not end in .png: the difference picture is a PNG",
                output.display()
            )));
        }
        frame::check_writable(output)?;
    }
    let is_scene = |path: &Path| {
        path.extension()
            .is_some_and(|ending| ending.eq_ignore_ascii_case("toml"))
    };
    let comparison = match &arguments.right {
        None if is_scene(&arguments.left) => scenes(arguments, &arguments.left, common)?,
        Some(right) if is_scene(&arguments.left) && is_scene(right) => {
            scenes(arguments, right, common)?
        }
        Some(right) if !is_scene(&arguments.left) && !is_scene(right) => {
            pictures(arguments, right)?
        }
        _ => {
            return Err(Error::Usage(
                "`compare` takes one scene, two scenes or two image files".into(),
            ));
        }
    };
    if common.json {
        report::print(&report::json(&comparison))?;
    } else if !common.quiet {
        report::print(&summary(&comparison))?;
    }
    Ok(if comparison.pass {
        Outcome::Done
    } else {
        Outcome::FellShort
    })
}

/// The left scene on the GPU, the right one on the CPU.
fn scenes(arguments: &CompareArguments, right: &Path, common: &Common) -> Result<Comparison> {
    let place = &arguments.place;
    let effects = &arguments.effects;
    let left_scene = effects.change(place.load(&arguments.left)?)?;
    let right_scene = effects.change(place.load(right)?)?;
    same_size(&left_scene.image, &right_scene.image)?;
    let gpu = place.open_gpu()?;
    let mut otherwise = Tolerance::default();
    if !gpu.is_bit_exact() {
        let pixels = u64::from(left_scene.image.width) * u64::from(left_scene.image.height);
        otherwise = Tolerance {
            different_pixels: pixels * INEXACT_OUTLIERS / 1000,
            ..INEXACT
        };
        tracing::warn!(
            "{} may contract or round loosely, so equal bits are not expected: \
             values may differ by {} ulp, and {} pixels by more",
            gpu.adapter.name,
            otherwise.max_ulp,
            otherwise.different_pixels
        );
    }
    let settings = Settings {
        bounds: place.bounds()?,
        forced: arguments.effects.forced()?,
        ..Settings::default()
    };
    let tolerance = arguments.tolerance(otherwise);
    let backend = Backend::Gpu(Box::new(gpu));
    let name = format!("{} on {}", arguments.left.display(), backend.describe());
    let progress = Progress::new(common, name.clone());
    let on_gpu = render(&left_scene, &backend, settings, &progress)?;
    drop(progress);
    let cpu = Backend::Cpu(place.threads);
    let cpu_name = format!("{} on {}", right.display(), cpu.describe());
    let progress = Progress::new(common, cpu_name.clone());
    let on_cpu = render(&right_scene, &cpu, settings, &progress)?;
    drop(progress);
    warn_of_faults(&on_cpu.stats);
    let mut comparison = compare_frames(&on_gpu.frame, &on_cpu.frame, &tolerance)?;
    comparison.left = name;
    comparison.right = cpu_name;
    if let Some(output) = &arguments.output {
        let map = difference_of_frames(&on_gpu.frame, &on_cpu.frame, DifferenceMap::Absolute)?;
        frame::write_rgb8(output, on_gpu.frame.width, on_gpu.frame.height, &map)?;
    }
    Ok(comparison)
}

/// Known before the first ray.
fn same_size(left: &Image, right: &Image) -> Result<()> {
    if (left.width, left.height) == (right.width, right.height) {
        return Ok(());
    }
    Err(Error::Usage(format!(
        "the left scene is {} x {} pixels and the right one {} x {}: \
         give both one size with `--size`",
        left.width, left.height, right.width, right.height
    )))
}

fn pictures(arguments: &CompareArguments, right: &Path) -> Result<Comparison> {
    let left = read_image(&arguments.left)?;
    let right = read_image(right)?;
    let comparison = compare_pictures(&left, &right, &arguments.tolerance(Tolerance::default()))?;
    if let Some(output) = &arguments.output {
        let map = difference_of_pictures(&left, &right, DifferenceMap::Absolute)?;
        frame::write_rgb8(output, left.width, left.height, &map)?;
    }
    Ok(comparison)
}

fn summary(comparison: &Comparison) -> String {
    let or_none = |value: Option<f64>, unit: &str| {
        value.map_or("-".to_string(), |value| format!("{value:.4}{unit}"))
    };
    let mut text = table(&[
        ("left", comparison.left.clone()),
        ("right", comparison.right.clone()),
        ("pixels", comparison.pixels.to_string()),
        ("different pixels", comparison.different_pixels.to_string()),
        ("different ids", comparison.id_mismatches.to_string()),
        (
            "largest difference",
            format!("{:e}, {} ulp", comparison.max_abs, comparison.max_ulp),
        ),
        ("rmse", format!("{:e}", comparison.rmse)),
        ("psnr", or_none(comparison.psnr_db, " dB")),
        ("flip", or_none(comparison.flip, "")),
    ]);
    let rows: Vec<(&str, String)> = comparison.layers.iter().map(layer_row).collect();
    for row in table(&rows).lines() {
        text += &format!("  {row}\n");
    }
    text += match (comparison.pass, comparison.different_pixels) {
        (true, 0) => "equal, bit for bit\n",
        (true, _) => "equal within the tolerance\n",
        (false, _) => "DIFFERENT\n",
    };
    text
}

fn layer_row(layer: &LayerDifference) -> (&str, String) {
    let largest = match layer.max_ulp {
        Some(ulp) => format!(", largest {ulp} ulp"),
        // Ids have no distance.
        None => String::new(),
    };
    (
        &layer.layer,
        format!("{} different{largest}", layer.different_pixels),
    )
}

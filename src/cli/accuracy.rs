//! `rayproof accuracy`.

pub(super) mod flags;
mod level;
mod results;

use self::flags::{AccuracyArguments, ErrorLayer, Written};
use self::level::Level;
use self::results::{LevelRows, Results};
use super::Outcome;
use super::flags::Common;
use super::paths::warn_of_paths;
use super::report;
use rayproof::accuracy::errors::{ulps_off, verdict};
use rayproof::error::{Error, Result};
use rayproof::frame::{self, Layer, check_writable, ulp_colors, write_atomically, wrong_colors};
use rayproof::layout::NO_HIT;
use rayproof::render::{Accuracy, Backend};
use rayproof::scene::Scene;

/// Measures what each tier costs and how far it is from the exact answer.
pub(super) fn run(arguments: &AccuracyArguments, common: &Common) -> Result<Outcome> {
    let written = arguments.written()?;
    if let Written::Plot(path) | Written::Picture(path, _) = written {
        check_writable(path)?;
    }
    let scene = arguments.load()?;
    scene.validate()?;
    warn_of_paths(&scene, "`accuracy` measures");
    let backends = arguments.backends()?;
    let tiers = arguments.tiers();
    let bounds = arguments.bounds();
    let plan = arguments.plan();
    let mut results = Results {
        scene: arguments.scene.display().to_string(),
        width: scene.image.width,
        height: scene.image.height,
        adapter: backends.iter().find_map(|backend| match backend {
            Backend::Cpu(_) => None,
            Backend::Gpu(gpu) => Some(gpu.adapter.name.clone()),
        }),
        clock: "wall",
        warmup: plan.warm_ups,
        budget_s: plan.budget,
        hazard: arguments.hazard().map(|hazard| hazard.name()),
        tiers: Vec::new(),
        levels: Vec::new(),
    };
    if let Some(hazard) = arguments.hazard() {
        for &step in hazard.levels() {
            let rows = hazard.apply(&scene, step).and_then(|harder| {
                let level = Level::of(&harder, bounds, common)?;
                level.measure(&backends, &tiers, &plan, common)
            });
            let (reason, tiers) = match rows {
                Ok(rows) => (None, rows),
                // A scene may be too large or too far at some step.
                Err(Error::Usage(reason) | Error::Limit(reason)) => (Some(reason), Vec::new()),
                Err(error) => return Err(error),
            };
            results.levels.push(LevelRows {
                level: step,
                reason,
                tiers,
            });
        }
        if let [
            LevelRows {
                reason: Some(reason),
                ..
            },
            rest @ ..,
        ] = results.levels.as_slice()
            && rest.iter().all(|level| level.reason.is_some())
        {
            return Err(Error::Usage(reason.clone()));
        }
    } else {
        let level = Level::of(&scene, bounds, common)?;
        if let Written::Picture(path, layer) = written {
            let rgb = error_picture(&level, &scene, &backends, tiers[0], layer)?;
            frame::write_rgb8(path, results.width, results.height, &rgb)?;
        }
        results.tiers = level.measure(&backends, &tiers, &plan, common)?;
    }
    if let Written::Plot(path) = written {
        write_atomically(path, results.plot().to_svg().as_bytes())?;
    }
    if common.json {
        report::print(&report::json(&results))?;
    } else if !common.quiet {
        report::print(&results.text(plan.runs))?;
    }
    Ok(Outcome::Done)
}

/// A picture of the errors of a tier's intersections, on the last of the backends that has it.
fn error_picture(
    level: &Level,
    scene: &Scene,
    backends: &[Backend],
    tier: Accuracy,
    layer: ErrorLayer,
) -> Result<Vec<u8>> {
    let has_it = backends
        .iter()
        .rev()
        .find(|backend| backend.lacks(tier).is_none());
    let found = level.found(has_it.unwrap_or(&backends[0]), tier)?;
    let rays = found.iter().zip(&level.rounded_truths.0);
    Ok(match layer {
        ErrorLayer::Ulp => {
            let errors: Vec<f64> = rays
                .map(|(found, truth)| match (found.id, truth.id) {
                    (NO_HIT, NO_HIT) => f64::NAN,
                    (NO_HIT, _) | (_, NO_HIT) => f64::INFINITY,
                    _ => ulps_off(found, truth),
                })
                .collect();
            ulp_colors(&errors)
        }
        ErrorLayer::Wrong => {
            let base = level.picture().to_rgb8(Layer::Color, scene.image.transfer);
            let verdicts: Vec<_> = rays
                .map(|(found, truth)| verdict(found.id, truth.id))
                .collect();
            wrong_colors(&base, &verdicts)
        }
    })
}

//! `rayproof plan`.

pub(super) mod flags;
mod results;

use self::flags::PlanArguments;
use self::results::{Cost, Proof, Results, Row};
use super::Outcome;
use super::flags::Common;
use super::progress::Progress;
use super::report;
use rayproof::effects::{EffectSet, without};
use rayproof::error::Result;
use rayproof::measure::{Spread, interleave};
use rayproof::plan::{ScenePlan, plan};
use rayproof::render::{Backend, Settings, render};
use rayproof::scene::Scene;

/// Says what a scene calls for; with `--measure`, what each effect costs, and that those
/// left out would change nothing.
pub(super) fn run(arguments: &PlanArguments, common: &Common) -> Result<Outcome> {
    let scene = arguments.tracing.place.load(&arguments.scene)?;
    let scene = arguments.effects.change(scene)?;
    let settings = Settings {
        forced: arguments.effects.forced()?,
        ..arguments.tracing.settings()?
    };
    let plan = plan(&scene, settings)?;
    let mut results = Results::of(&arguments.scene, &scene, &plan);
    if arguments.measure {
        let backend = arguments.tracing.open_backend()?;
        tracing::info!("measuring on {}", backend.describe());
        results.backend = Some(backend.describe());
        if backend.has_shaders() {
            results.proof = Some(prove(&scene, &backend, settings, common)?);
        } else {
            tracing::warn!("nothing is left out of the CPU's code: the proof needs a GPU");
        }
        let costs = measure(&scene, &backend, settings, &plan, arguments, common)?;
        results.take_costs(costs);
    }
    if common.json {
        report::print(&report::json(&results))?;
    } else if !common.quiet {
        report::print(&results.table())?;
    }
    let proven = results.proof.is_none_or(|proof| proof.equal);
    Ok(if proven {
        Outcome::Done
    } else {
        Outcome::FellShort
    })
}

/// Renders the scene with the shader that it calls for and with the one of all effects, and
/// compares their bits.
fn prove(scene: &Scene, backend: &Backend, settings: Settings, common: &Common) -> Result<Proof> {
    let progress = Progress::new(common, "as the scene calls for it");
    let pruned = render(scene, backend, settings, &progress)?;
    drop(progress);
    let progress = Progress::new(common, "with all effects");
    let full = Settings {
        forced: EffectSet::all(),
        ..settings
    };
    let full = render(scene, backend, full, &progress)?;
    let colors = pruned.frame.color.iter().zip(&full.frame.color);
    let differ =
        |(left, right): (&[f32; 3], &[f32; 3])| left.map(f32::to_bits) != right.map(f32::to_bits);
    Ok(Proof {
        equal: pruned.frame.has_bits_of(&full.frame),
        different_pixels: colors.filter(|pair| differ(*pair)).count(),
        ratio: full.stats.trace_ms / pruned.stats.trace_ms,
    })
}

/// Of each effect that can be taken out of the scene, what it costs: the scene's time with it
/// and without it, in turns.
fn measure(
    scene: &Scene,
    backend: &Backend,
    settings: Settings,
    plan: &ScenePlan,
    arguments: &PlanArguments,
    common: &Common,
) -> Result<Vec<(&'static str, Cost)>> {
    let names: Vec<&'static str> = plan
        .on()
        .filter(|effect| effect.is_removable)
        .map(|effect| effect.name)
        .collect();
    let mut scenes = vec![scene.clone()];
    for name in &names {
        scenes.push(without(scene, name)?);
    }
    let times = interleave(&arguments.runs.plan(), scenes.len(), &mut |turn| {
        let label = match turn.job {
            0 => "with all that it calls for".to_owned(),
            job => format!("without {}", names[job - 1]),
        };
        let progress = Progress::new(common, label);
        let rendering = render(&scenes[turn.job], backend, settings, &progress)?;
        Ok(rendering.stats.trace_ms / 1e3)
    })?;
    let whole = Spread::of(&times[0].seconds);
    let costs = times[1..].iter().map(|left| {
        let rest = Spread::of(&left.seconds);
        Cost {
            with_ms: whole.median * 1e3,
            without_ms: rest.median * 1e3,
            share: 1.0 - rest.median / whole.median,
        }
    });
    Ok(names.into_iter().zip(costs).collect())
}

/// An effect's row as it is before anything is measured.
fn row_of(effect: &rayproof::plan::PlannedEffect) -> Row {
    Row {
        name: effect.name,
        on: effect.on,
        reason: effect.reason.clone(),
        cost_ms: None,
        cost: None,
    }
}

//! `rayproof bench`.

mod case;
pub(super) mod flags;
mod results;
mod scale;

use std::time::Instant;

use self::case::{Case, Tracer};
use self::flags::BenchArguments;
use self::results::{Results, Row};
use super::Outcome;
use super::flags::Common;
use super::paths::warn_of_paths;
use super::progress::Progress;
use super::report;
use rayproof::bounds::{self, Bounds};
use rayproof::compare::{Tolerance, compare_frames};
use rayproof::cpu;
use rayproof::error::Result;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::frame::Frame;
use rayproof::measure::{Plan, Spread, Times, interleave};
use rayproof::scene::Scene;

/// Times every choice of volumes on every backend, side by side, and holds their
/// pictures to the first one's.
pub(super) fn run(arguments: &BenchArguments, common: &Common) -> Result<Outcome> {
    if let Some(sizes) = arguments.sizes() {
        return scale::run(&sizes, arguments, common);
    }
    let scene = arguments.load()?;
    scene.validate()?;
    warn_of_paths(&scene, "`bench` times");
    let device = arguments.open_gpu()?;
    if let Some(device) = device.as_ref().filter(|device| !device.is_bit_exact()) {
        tracing::warn!(
            "{} may contract or round loosely, so its pictures may differ from the CPU's",
            device.adapter.name
        );
    }
    let plan = arguments.plan();
    let scenes = bounded_scenes(&scene, &arguments.bounds(), &plan)?;
    let mut cases = Vec::new();
    for threads in arguments.threads(device.as_ref()) {
        for scene in &scenes {
            let prepared = cpu::Prepared::new(&scene.flat, threads)?;
            cases.push(Case::new(scene, Tracer::Cpu(prepared)));
        }
    }
    if let Some(device) = &device {
        for scene in &scenes {
            cases.push(Case::new(scene, Tracer::on_gpu(device, scene)?));
        }
    }
    let times = measure(&mut cases, &scene, &plan, common)?;
    if arguments.count {
        for case in &mut cases {
            let progress = Progress::new(common, format!("{}, counting", case.name()));
            case.counters = Some(case.tracer.count(case.scene, &progress)?);
        }
    }

    let results = Results {
        scene: arguments.scene().display().to_string(),
        width: scene.image.width,
        height: scene.image.height,
        primitives: scenes[0].flat.primitives(),
        clock: "wall",
        warmup: plan.warm_ups,
        budget_s: plan.budget,
        equal: cases.iter().all(|case| case.different_pixels == 0),
        runs: rows(&cases, &times, &scene),
    };
    if common.json {
        report::print(&report::json(&results))?;
    } else if !common.quiet {
        report::print(&results.table(plan.runs))?;
    }
    Ok(if results.equal {
        Outcome::Done
    } else {
        Outcome::FellShort
    })
}

/// A flattened scene with its volumes.
struct BoundedScene {
    bounds: Bounds,
    flat: Flat<f32>,
    /// Seconds that building the volumes took.
    build: Spread,
}

/// Builds each kind of volumes as often as the plan says.
fn bounded_scenes(scene: &Scene, choices: &[Bounds], plan: &Plan) -> Result<Vec<BoundedScene>> {
    let flat = flatten::<f32>(scene);
    let mut flats = vec![flat; choices.len()];
    let times = interleave(plan, choices.len(), &mut |turn| {
        let started = Instant::now();
        bounds::bound(&mut flats[turn.job], choices[turn.job]);
        Ok(started.elapsed().as_secs_f64())
    })?;
    let built = choices.iter().zip(flats).zip(&times);
    Ok(built
        .map(|((&bounds, flat), times)| BoundedScene {
            bounds,
            flat,
            build: Spread::of(&times.seconds),
        })
        .collect())
}

/// Runs all cases in turn, and compares each picture with the very first one.
fn measure(
    cases: &mut [Case<'_>],
    scene: &Scene,
    plan: &Plan,
    common: &Common,
) -> Result<Vec<Times>> {
    let mut frame = Frame::new(scene.image.width, scene.image.height)?;
    let mut first: Option<Frame> = None;
    interleave(plan, cases.len(), &mut |turn| {
        let case = &mut cases[turn.job];
        let progress = Progress::new(common, case.label(turn));
        let seconds = case.trace(turn, &mut frame, &progress)?;
        drop(progress);
        match &first {
            None => first = Some(frame.clone()),
            Some(first) if first.has_bits_of(&frame) => {}
            Some(first) => {
                let comparison = compare_frames(first, &frame, &Tolerance::default())?;
                case.different_pixels = case.different_pixels.max(comparison.different_pixels);
            }
        }
        Ok(seconds)
    })
}

fn rows(cases: &[Case<'_>], times: &[Times], scene: &Scene) -> Vec<Row> {
    let rays = f64::from(scene.image.width) * f64::from(scene.image.height);
    let measured = cases.iter().zip(times);
    measured
        .map(|(case, own)| {
            let without = cases.iter().position(|other| {
                other.scene.bounds == Bounds::None
                    && (other.backend(), other.threads()) == (case.backend(), case.threads())
            });
            let speedup = without.map(|index| own.speedup_over(&times[index]));
            let against_first = own.speedup_over(&times[0]);
            let trace_ms = Spread::of(&own.seconds).times(1e3);
            let search_speedup = without
                .and_then(|index| cases[index].search_ms())
                .zip(case.search_ms())
                .map(|(without, own)| without / own);
            Row {
                backend: case.backend(),
                adapter: case.adapter().map(str::to_string),
                threads: case.threads(),
                bounds: case.scene.bounds,
                runs: own.seconds.len(),
                from_warm_up: own.from_warm_up,
                median_ms: trace_ms.median,
                min_ms: trace_ms.min,
                max_ms: trace_ms.max,
                mrays_per_s: rays / trace_ms.median / 1e3,
                speedup: speedup.map(|ratio| ratio.median),
                speedup_range: speedup.and_then(|ratio| ratio.range),
                against_first: against_first.median,
                against_first_range: against_first.range,
                search_ms: case.search_ms(),
                search_speedup,
                shade_ms: case.device_ms(|seconds| seconds.shade),
                build_ms: case.build_ms(),
                counters: case.counters,
                equal: case.different_pixels == 0,
                different_pixels: case.different_pixels,
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    /// Measures a scene on the CPU, without volumes and with a tree, after
    /// `change` was done to the second of the two; gives the pixels that differ.
    fn different_pixels(change: fn(&mut Flat<f32>)) -> [u64; 2] {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes/shapes.toml");
        let scene = Scene::load(file).unwrap().with_size(60, 40);
        let plan = Plan {
            warm_ups: 0,
            runs: 2,
            budget: 60.0,
        };
        let mut scenes = bounded_scenes(&scene, &[Bounds::None, Bounds::Tree], &plan).unwrap();
        change(&mut scenes[1].flat);
        let mut cases = Vec::new();
        for scene in &scenes {
            let prepared = cpu::Prepared::new(&scene.flat, None).unwrap();
            cases.push(Case::new(scene, Tracer::Cpu(prepared)));
        }
        let line = ["rayproof", "--quiet", "doctor"];
        let common = crate::cli::flags::Cli::parse_from(line).common;
        let times = measure(&mut cases, &scene, &plan, &common).unwrap();
        assert!(times.iter().all(|times| times.seconds.len() == 2));
        [cases[0].different_pixels, cases[1].different_pixels]
    }

    #[test]
    fn a_volume_that_cuts_the_picture_is_noticed() {
        assert_eq!(different_pixels(|_| {}), [0, 0]);
        let [first, second] = different_pixels(|flat| flat.spheres[1].radius *= 0.99);
        assert_eq!(first, 0);
        assert!(second > 0);
        // All leaves hold one shape.
        let [_, lost] = different_pixels(|flat| flat.pairs[0].right = flat.pairs[0].left);
        assert!(lost > 0);
    }
}

//! One scene, measured in every tier on every backend.

use super::results::Row;
use crate::cli::flags::Common;
use crate::cli::progress::Progress;
use rayproof::accuracy::truth::{exact_rays, rounded_rays};
use rayproof::accuracy::{Errors, Tracer, Truths, Widths};
use rayproof::bounds::Bounds;
use rayproof::compare::{Tolerance, compare_frames};
use rayproof::error::Result;
use rayproof::flatten::flatten;
use rayproof::found::Found;
use rayproof::frame::Frame;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::vector::vector_length;
use rayproof::measure::{Plan, Spread, Times, Turn, interleave};
use rayproof::oracle::Truth;
use rayproof::render::{Accuracy, Backend};
use rayproof::scene::Scene;

/// A scene with the exact answers.
pub(super) struct Level {
    exact: Widths,
    exact_rays: Vec<Ray<f64>>,
    exact_truths: Truths,
    exact_frame: Frame,
    /// The same scene and rays rounded to f32: what tells the error of an intersection from
    /// that of its input.
    rounded: Widths,
    rounded_rays: Vec<Ray<f32>>,
    pub(super) rounded_truths: Truths,
}

impl Level {
    /// Asks the oracle.
    pub(super) fn of(scene: &Scene, bounds: Bounds, common: &Common) -> Result<Self> {
        scene.validate()?;
        let flat = flatten::<f64>(scene);
        let (exact_rays, rounded_rays) = (exact_rays(&flat), rounded_rays(&flat));
        let mut rounded = flat.converted::<f32>().converted::<f64>();
        rounded.take_powers_anew();
        let rounded = Widths::of(rounded, bounds);
        let exact = Widths::of(flat, bounds);
        let widened: Vec<Ray<f64>> = rounded_rays.iter().map(|ray| ray.converted()).collect();
        let progress = Progress::new(common, "the exact hits");
        let exact_truths = Truths::of(&exact.double, &exact_rays, &progress)?;
        let progress = Progress::new(common, "the exact hits, rounded scene");
        let rounded_truths = Truths::of(&rounded.double, &widened, &progress)?;
        Ok(Self {
            exact_frame: exact_truths.frame(&exact.double, &exact_rays)?,
            exact,
            exact_rays,
            exact_truths,
            rounded,
            rounded_rays,
            rounded_truths,
        })
    }

    /// What a tier finds on the rounded rays.
    pub(super) fn found(&self, backend: &Backend, tier: Accuracy) -> Result<Vec<Found>> {
        let found = self.rounded.trace_rays(backend, tier, &self.rounded_rays)?;
        Ok(found.0)
    }

    /// The exact picture.
    pub(super) fn picture(&self) -> &Frame {
        &self.exact_frame
    }

    /// Times every tier on every backend, interleaved, and finds its errors.
    pub(super) fn measure(
        &self,
        backends: &[Backend],
        tiers: &[Accuracy],
        plan: &Plan,
        common: &Common,
    ) -> Result<Vec<Row>> {
        let mut rows = Vec::new();
        let mut cases = Vec::new();
        for backend in backends {
            for &tier in tiers {
                match backend.lacks(tier) {
                    Some(reason) => rows.push(Row::unavailable(backend, tier, reason)),
                    None => {
                        cases.push(Case {
                            backend,
                            tier,
                            // Before the runs: what it cannot do is told now.
                            found: self.found(backend, tier)?,
                            tracer: self.exact.tracer(backend, tier, false)?,
                            timed: match backend {
                                Backend::Gpu(gpu) if gpu.has_clock() => {
                                    Some(self.exact.tracer(backend, tier, true)?)
                                }
                                _ => None,
                            },
                            device_seconds: Vec::new(),
                            frame: Frame::new(self.exact_frame.width, self.exact_frame.height)?,
                        })
                    }
                }
            }
        }
        let times = interleave(plan, cases.len(), &mut |turn| {
            let case = &mut cases[turn.job];
            let label = format!(
                "{} {}, run {}",
                case.backend.name(),
                case.tier.name(),
                turn.number
            );
            case.run(turn, &Progress::new(common, label))
        })?;
        for (case, own) in cases.iter().zip(&times) {
            let textbook = cases.iter().position(|other| {
                other.backend.name() == case.backend.name() && other.tier == Accuracy::Textbook
            });
            let mut row = self.row(case, own)?;
            row.cost = textbook.map(|index| median(own) / median(&times[index]));
            row.device_cost = textbook
                .and_then(|index| cases[index].device_ms())
                .zip(case.device_ms())
                .map(|(textbook, own)| own / textbook);
            rows.push(row);
        }
        rows.sort_by_key(|row| (row.backend, row.tier));
        Ok(rows)
    }

    fn row(&self, case: &Case<'_>, times: &Times) -> Result<Row> {
        let comparison = compare_frames(&case.frame, &self.exact_frame, &Tolerance::default())?;
        let ms = Spread::of(&times.seconds).times(1e3);
        Ok(Row {
            runs: times.seconds.len(),
            from_warm_up: times.from_warm_up,
            median_ms: Some(ms.median),
            min_ms: Some(ms.min),
            max_ms: Some(ms.max),
            mrays_per_s: Some(self.exact_rays.len() as f64 / ms.median / 1e3),
            device_ms: case.device_ms(),
            retraced: (case.tier == Accuracy::Adaptive).then(|| case.tracer.retraced()),
            errors: Some(Errors::of(&case.found, &self.rounded_truths.0)),
            total: Some(self.total_errors(&case.frame)),
            rmse: Some(comparison.rmse),
            flip: comparison.flip,
            ..Row::of(case.backend, case.tier)
        })
    }

    /// The errors of a picture, in depth, with those of rounding scene and rays.
    fn total_errors(&self, frame: &Frame) -> Errors {
        let pixels = frame.id.iter().zip(&frame.depth);
        let found: Vec<Found> = pixels
            .map(|(id, depth)| Found::new(f64::from(*depth), *id))
            .collect();
        let truths = self.exact_truths.0.iter().zip(&self.exact_rays);
        let truths: Vec<Truth> = truths
            .map(|(truth, ray)| Truth {
                t: truth.t * vector_length(ray.direction),
                t_rest: 0.0,
                ..*truth
            })
            .collect();
        Errors::of(&found, &truths)
    }
}

/// A tier on a backend.
struct Case<'a> {
    backend: &'a Backend,
    tier: Accuracy,
    /// On the rounded rays.
    found: Vec<Found>,
    tracer: Box<dyn Tracer + 'a>,
    /// With passes that are timed, on a device with a clock.
    timed: Option<Box<dyn Tracer + 'a>>,
    /// Of all passes of a picture, for each run that counts.
    device_seconds: Vec<f64>,
    frame: Frame,
}

impl Case<'_> {
    /// Milliseconds of a picture by the device's clock.
    fn device_ms(&self) -> Option<f64> {
        (!self.device_seconds.is_empty()).then(|| Spread::of(&self.device_seconds).median * 1e3)
    }

    /// Traces a picture; gives the seconds.
    fn run(&mut self, turn: Turn, progress: &Progress) -> Result<f64> {
        let started = std::time::Instant::now();
        let frame = &mut self.frame;
        let mut complete = true;
        self.tracer.run(progress, &mut |row, pixels| {
            complete &= frame.keep_rows(row, pixels);
        })?;
        if !complete {
            tracing::warn!("some rays were given up: they count as misses");
        }
        let seconds = started.elapsed().as_secs_f64();
        if let Some(timed) = &mut self.timed {
            timed.run(progress, &mut |_, _| {})?;
            let passes = timed.seconds().filter(|_| !turn.warm_up);
            let both = passes.map(|seconds| seconds.trace + seconds.shade);
            self.device_seconds.extend(both);
        }
        Ok(seconds)
    }
}

fn median(times: &Times) -> f64 {
    Spread::of(&times.seconds).median
}

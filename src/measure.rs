//! Measuring: warm-up, interleaved runs, medians, and ratios with their spread.
//!
//! Nothing here reads a clock: a run says itself how long it took.

use crate::error::Result;

/// How often each of several jobs is run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plan {
    /// Runs before the ones that count: caches fill, drivers compile, clocks rise.
    pub warm_ups: u32,
    /// Runs that count, at least one.
    pub runs: u32,
    /// Seconds after which a job is run no more.
    pub budget: f64,
}

/// One run of one job.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Turn {
    /// The job, counted from 0.
    pub job: usize,
    /// Whether this run only warms up.
    pub warm_up: bool,
    /// The number of the run, or of the warm-up, counted from 1.
    pub number: u32,
}

/// How long the runs of one job took.
#[derive(Debug, Clone, PartialEq)]
pub struct Times {
    /// The seconds of each run, in their order; at least one.
    pub seconds: Vec<f64>,
    /// The budget was spent before a run counted, so this is the last warm-up.
    pub from_warm_up: bool,
}

impl Times {
    /// How many times faster this job is than `reference`.
    pub fn speedup_over(&self, reference: &Self) -> Speedup {
        let (own, other) = (Spread::of(&self.seconds), Spread::of(&reference.seconds));
        let repeated = self.seconds.len() > 1 && reference.seconds.len() > 1;
        Speedup {
            median: other.median / own.median,
            range: repeated.then(|| [other.min / own.max, other.max / own.min]),
        }
    }
}

/// How many times faster one job is than another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Speedup {
    /// The ratio of the medians.
    pub median: f64,
    /// The least and the greatest ratio that a run of the one and a run of the
    /// other give; none where one of them was run only once, which says nothing
    /// of the spread.
    pub range: Option<[f64; 2]>,
}

/// Runs `jobs` jobs in turn (A B C, A B C, ...), so that a machine which slows
/// down or speeds up meanwhile does so for all of them. `run` gives the seconds
/// that it took. A job that has spent its budget, warm-ups included, is run no
/// more; each is run at least once.
///
/// # Errors
///
/// The first one of `run`.
pub fn interleave(
    plan: &Plan,
    jobs: usize,
    run: &mut dyn FnMut(Turn) -> Result<f64>,
) -> Result<Vec<Times>> {
    let runs = plan.runs.max(1);
    // Of each job, the seconds of its warm-ups and of its other runs.
    let mut taken = vec![(Vec::new(), Vec::new()); jobs];
    for round in 0..plan.warm_ups + runs {
        let warm_up = round < plan.warm_ups;
        let number = 1 + if warm_up {
            round
        } else {
            round - plan.warm_ups
        };
        for (job, (warm_ups, counted)) in taken.iter_mut().enumerate() {
            if warm_ups.iter().chain(&*counted).sum::<f64>() > plan.budget {
                continue;
            }
            let seconds = run(Turn {
                job,
                warm_up,
                number,
            })?;
            if warm_up {
                warm_ups.push(seconds);
            } else {
                counted.push(seconds);
            }
        }
    }
    let times = taken.into_iter().map(|(warm_ups, counted)| Times {
        from_warm_up: counted.is_empty(),
        seconds: if counted.is_empty() {
            warm_ups.last().copied().into_iter().collect()
        } else {
            counted
        },
    });
    Ok(times.collect())
}

/// The middle and the ends of what was measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Half lie above, half below; of an even number, midway between the two in
    /// the middle.
    pub median: f64,
    /// The least.
    pub min: f64,
    /// The greatest.
    pub max: f64,
}

impl Spread {
    /// Of these values; without any, all NaN.
    pub fn of(values: &[f64]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let (Some(&min), Some(&max)) = (sorted.first(), sorted.last()) else {
            return Self {
                median: f64::NAN,
                min: f64::NAN,
                max: f64::NAN,
            };
        };
        let middle = sorted.len() / 2;
        let median = if sorted.len() % 2 == 1 {
            sorted[middle]
        } else {
            (sorted[middle - 1] + sorted[middle]) / 2.0
        };
        Self { median, min, max }
    }

    /// Every value `factor` times as large; `factor` is positive.
    pub fn times(self, factor: f64) -> Self {
        Self {
            median: self.median * factor,
            min: self.min * factor,
            max: self.max * factor,
        }
    }
}

/// The exponent e with which y grows as x^e: the slope of a line through the logarithms,
/// by least squares. NaN of fewer than two points.
pub fn growth_exponent(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let logarithms = points.iter().map(|&(x, y)| (x.ln(), y.ln()));
    let (sum_x, sum_y) = logarithms
        .clone()
        .fold((0.0, 0.0), |(sum_x, sum_y), (x, y)| (sum_x + x, sum_y + y));
    let (mean_x, mean_y) = (sum_x / count, sum_y / count);
    let (along, square) = logarithms.fold((0.0, 0.0), |(along, square), (x, y)| {
        let x = x - mean_x;
        (along + x * (y - mean_y), square + x * x)
    });
    along / square
}

#[cfg(test)]
mod tests;

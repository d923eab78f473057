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
mod tests {
    use super::*;
    use crate::error::Error;

    fn spread(median: f64, min: f64, max: f64) -> Spread {
        Spread { median, min, max }
    }

    #[test]
    fn medians_by_hand() {
        for (values, expected) in [
            (&[3.0][..], spread(3.0, 3.0, 3.0)),
            (&[9.0, 1.0, 2.0], spread(2.0, 1.0, 9.0)),
            (&[4.0, 1.0, 100.0, 2.0], spread(3.0, 1.0, 100.0)),
            (&[2.0, 2.0, 5.0, 2.0, 7.0], spread(2.0, 2.0, 7.0)),
        ] {
            assert_eq!(Spread::of(values), expected, "{values:?}");
        }
        // The mean of these is 35.
        assert_ne!(Spread::of(&[1.0, 4.0, 100.0]).median, 35.0);
        assert!(Spread::of(&[]).median.is_nan());
    }

    #[test]
    fn ratios_by_hand() {
        let speedup = |median, range| Speedup { median, range };
        let reference = counted(&[16.0, 10.0, 12.0]);
        let faster = counted(&[2.0, 4.0, 3.0]);
        assert_eq!(
            faster.speedup_over(&reference),
            speedup(4.0, Some([2.5, 8.0]))
        );
        assert_eq!(
            reference.speedup_over(&faster),
            speedup(0.25, Some([0.125, 0.4]))
        );
        // Against itself: 1, and as uncertain as its runs.
        assert_eq!(
            reference.speedup_over(&reference),
            speedup(1.0, Some([0.625, 1.6]))
        );
        let once = counted(&[6.0]);
        assert_eq!(once.speedup_over(&reference), speedup(2.0, None));
        assert_eq!(reference.speedup_over(&once), speedup(0.5, None));
        let spread_of_three = Spread::of(&faster.seconds);
        assert_eq!(
            spread_of_three.times(1000.0),
            spread(3000.0, 2000.0, 4000.0)
        );
    }

    #[test]
    fn exponents_by_hand() {
        let points = |exponent: i32| [1.0, 3.0, 9.0].map(|x: f64| (x, 5.0 * x.powi(exponent)));
        for exponent in [-1, 0, 1, 2] {
            let fitted = growth_exponent(&points(exponent));
            assert!((fitted - f64::from(exponent)).abs() < 1e-12, "{fitted}");
        }
        // Twice as long for four times as much, with one point off.
        let fitted = growth_exponent(&[(1.0, 1.0), (4.0, 2.0), (16.0, 4.4)]);
        assert!(fitted > 0.5 && fitted < 0.6, "{fitted}");
        assert!(growth_exponent(&[(2.0, 3.0)]).is_nan());
    }

    /// Runs three jobs that take 1, 2 and 8 seconds, and 10 times as long when
    /// cold; gives the order and the times.
    fn run_three(plan: Plan) -> (String, Vec<Times>) {
        let mut order = String::new();
        let mut cold = [true; 3];
        let times = interleave(&plan, 3, &mut |turn| {
            let letter = ['a', 'b', 'c'][turn.job];
            order.push(if turn.warm_up {
                letter.to_ascii_uppercase()
            } else {
                letter
            });
            order += &turn.number.to_string();
            let factor = if std::mem::take(&mut cold[turn.job]) {
                10.0
            } else {
                1.0
            };
            Ok(factor * [1.0, 2.0, 8.0][turn.job])
        });
        (order, times.unwrap())
    }

    fn counted(seconds: &[f64]) -> Times {
        Times {
            seconds: seconds.to_vec(),
            from_warm_up: false,
        }
    }

    #[test]
    fn runs_take_turns_and_warm_ups_do_not_count() {
        let plan = Plan {
            warm_ups: 1,
            runs: 2,
            budget: 1e3,
        };
        let (order, times) = run_three(plan);
        assert_eq!(order, "A1B1C1a1b1c1a2b2c2");
        let expected = [[1.0, 1.0], [2.0, 2.0], [8.0, 8.0]].map(|s| counted(&s));
        assert_eq!(times, expected);
    }

    /// The control of the last test: without a warm-up, the cold run counts.
    #[test]
    fn without_a_warm_up_the_cold_run_counts() {
        let plan = Plan {
            warm_ups: 0,
            runs: 2,
            budget: 1e3,
        };
        let (order, times) = run_three(plan);
        assert_eq!(order, "a1b1c1a2b2c2");
        assert_eq!(times[2], counted(&[80.0, 8.0]));
    }

    #[test]
    fn a_job_that_spent_its_budget_is_run_no_more() {
        let plan = Plan {
            warm_ups: 1,
            runs: 3,
            budget: 21.0,
        };
        // b has spent 20 + 2 after its first run, c 80 in its warm-up.
        let (order, times) = run_three(plan);
        assert_eq!(order, "A1B1C1a1b1a2a3");
        assert_eq!(times[0], counted(&[1.0; 3]));
        assert_eq!(times[1], counted(&[2.0]));
        let cold = Times {
            seconds: vec![80.0],
            from_warm_up: true,
        };
        assert_eq!(times[2], cold);
    }

    #[test]
    fn every_job_is_run_once_even_without_a_budget() {
        let plan = Plan {
            warm_ups: 0,
            runs: 0,
            budget: 0.0,
        };
        assert_eq!(run_three(plan).0, "a1b1c1");
    }

    #[test]
    fn an_error_ends_it() {
        let plan = Plan {
            warm_ups: 1,
            runs: 5,
            budget: 1.0,
        };
        let mut calls = 0;
        let outcome = interleave(&plan, 2, &mut |turn| {
            calls += 1;
            if turn.job == 1 {
                return Err(Error::Interrupted);
            }
            Ok(0.1)
        });
        assert!(matches!(outcome, Err(Error::Interrupted)));
        assert_eq!(calls, 2);
    }
}

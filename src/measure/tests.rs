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

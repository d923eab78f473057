//! Each case can fail: the textbook tier fails it, or a broken formula does.

use rayproof::Accuracy;
use rayproof::random::Numbers;
use rayproof::stability::{Case, Subject, catalogue};

use super::broken::AS_IN_TEXTBOOKS;
use super::{broken_round, broken_shading, broken_straight};

/// What fails a case.
fn failing(case: &Case) -> Box<dyn Subject> {
    if case.is_expected_to_fail(Accuracy::Textbook) {
        return Box::new(AS_IN_TEXTBOOKS);
    }
    let of_families = [
        broken_round::broken_for,
        broken_straight::broken_for,
        broken_shading::broken_for,
    ];
    let broken = of_families.iter().find_map(|broken| broken(case.id));
    Box::new(broken.unwrap_or_else(|| panic!("{}: nothing fails it", case.id)))
}

#[test]
fn every_case_can_fail() {
    let mut passed = Vec::new();
    for case in catalogue() {
        let trial = (case.trial)(&mut Numbers(1), case.demands).unwrap();
        let tally = trial.run(&*failing(case)).unwrap();
        if tally.wrong == 0 {
            passed.push(format!("{}: {tally:?}", case.id));
        }
    }
    assert!(passed.is_empty(), "{passed:#?}");
}

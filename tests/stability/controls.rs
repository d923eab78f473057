//! Each case can fail: the textbook tier fails it, or a broken formula does, or both.

use rayproof::Accuracy;
use rayproof::random::Numbers;
use rayproof::stability::{Case, Subject, catalogue};

use super::broken::AS_IN_TEXTBOOKS;
use super::{broken_round, broken_shading, broken_straight};

/// All that must fail a case.
fn failing(case: &Case) -> Vec<Box<dyn Subject>> {
    let of_families = [
        broken_round::broken_for,
        broken_straight::broken_for,
        broken_shading::broken_for,
    ];
    let mut subjects: Vec<Box<dyn Subject>> = Vec::new();
    for broken in of_families.iter().filter_map(|broken| broken(case.id)) {
        subjects.push(Box::new(broken));
    }
    if case.is_expected_to_fail(Accuracy::Textbook) {
        subjects.push(Box::new(AS_IN_TEXTBOOKS));
    }
    subjects
}

#[test]
fn every_case_can_fail() {
    let mut passed = Vec::new();
    for case in catalogue() {
        let subjects = failing(case);
        assert!(!subjects.is_empty(), "{}: nothing fails it", case.id);
        let trial = (case.trial)(&mut Numbers(1), case.demands).unwrap();
        for subject in subjects {
            let tally = trial.run(&*subject).unwrap();
            if tally.wrong == 0 {
                passed.push(format!("{}: {tally:?}", case.id));
            }
        }
    }
    assert!(passed.is_empty(), "{passed:#?}");
}

//! Each case can fail: the textbook tier fails it, or a broken formula does.

use rayproof::Accuracy;
use rayproof::layout::NO_HIT;
use rayproof::random::Numbers;
use rayproof::stability::{Subject, catalogue};

use super::broken::{AsInTextbooks, Broken, rightly};
use super::broken_round;

/// For each case that the textbook passes, a formula that fails it.
fn broken_for(id: &str) -> Option<Box<dyn Subject>> {
    Some(match id {
        // Nothing is ever hit.
        "" => Box::new(Broken(|flat, ray| rayproof::found::Found {
            id: NO_HIT,
            ..rightly(flat, ray)
        })),
        _ => return broken_round::broken_for(id),
    })
}

#[test]
fn every_case_can_fail() {
    for case in catalogue() {
        let broken: Box<dyn Subject> = if case.is_expected_to_fail(Accuracy::Textbook) {
            Box::new(AsInTextbooks)
        } else {
            broken_for(case.id).unwrap_or_else(|| panic!("{}: nothing fails it", case.id))
        };
        let trial = (case.trial)(&mut Numbers(1), case.demands).unwrap();
        let tally = trial.run(&*broken).unwrap();
        assert!(tally.wrong > 0, "{}: {tally:?}", case.id);
    }
}

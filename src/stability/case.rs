//! A hard case, and how it came out.

use super::demand::Demand;
use super::subject::Subject;
use super::tally::Tally;
use crate::error::Result;
use crate::random::Numbers;
use crate::tier::Accuracy;

/// Cases of one kind.
pub struct Family {
    /// The name, with which the ids begin.
    pub name: &'static str,
    /// What they have in common, for people.
    pub about: &'static str,
    /// The cases, by theme.
    pub cases: &'static [&'static [Case]],
}

impl Family {
    /// The cases, in the order in which they are read.
    pub fn cases(&self) -> impl Iterator<Item = &'static Case> + use<> {
        self.cases.iter().copied().flatten()
    }
}

/// Sets a case up, given what it demands of each answer.
pub type SetUp = fn(&mut Numbers, &'static [Demand]) -> Result<Box<dyn Trial>>;

/// Where ray tracers break.
pub struct Case {
    /// The family and a name within it: `sphere/far-1e4`.
    pub id: &'static str,
    /// The name for people.
    pub name: &'static str,
    /// What it sets up.
    pub sets_up: &'static str,
    /// Why careless code fails.
    pub danger: &'static str,
    /// What must come out.
    pub demands: &'static [Demand],
    /// The tiers that are expected to fail.
    pub fails: &'static [Accuracy],
    /// Whether its rays are drawn, so that more rounds try more rays.
    pub is_random: bool,
    /// Sets it up.
    pub trial: SetUp,
}

impl Case {
    /// Whether a tier is expected to fail it.
    pub fn is_expected_to_fail(&self, tier: Accuracy) -> bool {
        self.fails.contains(&tier)
    }
}

/// A case that is set up.
pub trait Trial {
    /// Tries it.
    ///
    /// # Errors
    ///
    /// Those of the subject.
    fn run(&self, on: &dyn Subject) -> Result<Tally>;
}

/// How a case came out.
pub struct Verdict {
    /// The case.
    pub case: &'static Case,
    /// The tier.
    pub tier: Accuracy,
    /// What was counted.
    pub tally: Tally,
}

impl Verdict {
    /// Whether every ray had what was demanded.
    pub fn passes(&self) -> bool {
        self.tally.wrong == 0
    }

    /// Whether it came out as the catalogue says.
    pub fn is_as_expected(&self) -> bool {
        self.passes() != self.case.is_expected_to_fail(self.tier)
    }
}

//! A hard case, and how it came out.

use super::demand::Demand;
use super::subject::{Station, Subject};
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

/// Cases of lengths around 10^-15, and the tiers that fail them in two f32 on a device that
/// makes denormal numbers 0: the low half of a square is one there, and gone.
pub const NEED_DENORMALS: [(&str, &[Accuracy]); 2] = [
    ("sphere/smallest", &[Accuracy::Extended]),
    (
        "triangle/small-mesh",
        &[Accuracy::Extended, Accuracy::Adaptive],
    ),
];

impl Case {
    /// Whether a tier is expected to fail it, where denormal numbers are kept.
    pub fn is_expected_to_fail(&self, tier: Accuracy) -> bool {
        self.fails.contains(&tier)
    }

    /// The tiers of [`NEED_DENORMALS`].
    pub fn needs_denormals(&self) -> &'static [Accuracy] {
        let needs = NEED_DENORMALS.iter().find(|(id, _)| *id == self.id);
        needs.map_or(&[], |(_, tiers)| tiers)
    }

    /// Whether it is expected to fail at a station.
    pub fn is_expected_to_fail_at(&self, station: &Station<'_>) -> bool {
        let lacks = station.loses_halves() && self.needs_denormals().contains(&station.tier);
        self.is_expected_to_fail(station.tier) || lacks
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
    /// Whether it is expected to fall short there.
    pub is_expected_to_fail: bool,
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
        self.passes() != self.is_expected_to_fail
    }
}

//! How the hard cases came out, for people and for programs.

use serde::Serialize;

use crate::cli::report;
use rayproof::render::{Accuracy, Backend};
use rayproof::stability::{Case, Station, Verdict};

/// How the hard cases came out.
#[derive(Serialize)]
pub(super) struct Results {
    /// How often each case was tried, each time with other rays.
    pub(super) rounds: u32,
    pub(super) seconds: f64,
    pub(super) cases: Vec<Row>,
    pub(super) summary: Vec<Sum>,
}

/// How a case came out in a tier on a backend.
#[derive(Serialize)]
pub(super) struct Row {
    /// Which of the backends.
    #[serde(skip)]
    place: usize,
    id: &'static str,
    name: &'static str,
    tier: Accuracy,
    backend: &'static str,
    adapter: Option<String>,
    rays: u64,
    wrong: u64,
    /// The error that was largest in parts of its bound; none where it is not a number.
    worst: Option<f64>,
    bound: f64,
    pass: bool,
    /// It came out as the catalogue says, which may be that it fails.
    expected: bool,
}

/// How all cases came out in a tier on a backend.
#[derive(Serialize)]
pub(super) struct Sum {
    /// Which of the backends.
    #[serde(skip)]
    place: usize,
    tier: Accuracy,
    backend: &'static str,
    adapter: Option<String>,
    available: bool,
    /// Why the tier is not available.
    reason: Option<String>,
    passed: u32,
    /// Those that fell short and should not have.
    failed: u32,
    /// Those that fell short as they should.
    expected_failures: u32,
    /// Those of `passed` that should have fallen short: the expectation is wrong.
    unexpected_passes: u32,
}

fn adapter_of(backend: &Backend) -> Option<String> {
    match backend {
        Backend::Cpu(_) => None,
        Backend::Gpu(gpu) => Some(gpu.adapter.name.clone()),
    }
}

impl Row {
    pub(super) fn of(place: usize, station: &Station<'_>, verdict: &Verdict) -> Self {
        let tally = verdict.tally;
        Self {
            place,
            id: verdict.case.id,
            name: verdict.case.name,
            tier: station.tier,
            backend: station.backend.name(),
            adapter: adapter_of(station.backend),
            rays: tally.rays,
            wrong: tally.wrong,
            worst: Some(tally.worst).filter(|worst| worst.is_finite()),
            bound: tally.bound,
            pass: verdict.passes(),
            expected: verdict.is_as_expected(),
        }
    }

    /// Wrong rays, the worst error over its bound, and a mark.
    fn cell(&self) -> String {
        let mark = match (self.expected, self.pass) {
            (false, _) => " !",
            (true, false) => " *",
            (true, true) => "  ",
        };
        let part = match self.worst {
            Some(0.0) => "0".into(),
            Some(worst) if self.bound > 0.0 => short(worst / self.bound),
            _ => "-".into(),
        };
        format!("{} {part:>6}{mark}", self.wrong)
    }
}

/// A number in at most six characters.
fn short(part: f64) -> String {
    match part {
        _ if !(1e-3..1e4).contains(&part) => format!("{part:.0e}"),
        _ if part >= 100.0 => format!("{part:.0}"),
        _ if part >= 1.0 => format!("{part:.1}"),
        _ => format!("{part:.3}"),
    }
}

impl Sum {
    pub(super) fn of(place: usize, station: &Station<'_>) -> Self {
        let reason = station.lacks();
        Self {
            place,
            tier: station.tier,
            backend: station.backend.name(),
            adapter: adapter_of(station.backend),
            available: reason.is_none(),
            reason,
            passed: 0,
            failed: 0,
            expected_failures: 0,
            unexpected_passes: 0,
        }
    }

    pub(super) fn is_of(&self, row: &Row) -> bool {
        (self.place, self.tier) == (row.place, row.tier)
    }

    pub(super) fn add(&mut self, row: &Row) {
        self.passed += u32::from(row.pass);
        self.failed += u32::from(!row.pass && !row.expected);
        self.expected_failures += u32::from(!row.pass && row.expected);
        self.unexpected_passes += u32::from(row.pass && !row.expected);
    }

    /// Its counts; dashes where the tier is not available.
    fn cells(&self) -> [String; 5] {
        let count = |count: u32| match self.reason {
            None => count.to_string(),
            Some(_) => "-".into(),
        };
        [
            self.tier.name().into(),
            count(self.passed),
            count(self.expected_failures),
            count(self.failed),
            count(self.unexpected_passes),
        ]
    }
}

impl Results {
    /// The name of one of the backends.
    fn name_of(&self, place: usize) -> String {
        let sum = self.summary.iter().find(|sum| sum.place == place);
        match sum.map(|sum| (sum.backend, &sum.adapter)) {
            Some((backend, Some(adapter))) => format!("{backend} ({adapter})"),
            Some((backend, None)) => backend.into(),
            None => String::new(),
        }
    }

    /// Whether everything came out as the catalogue says.
    pub(super) fn are_as_expected(&self) -> bool {
        self.cases.iter().all(|row| row.expected)
    }

    /// A table for each backend, the sums, and what was not expected.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        let places = self.summary.iter().map(|sum| sum.place + 1).max();
        for place in 0..places.unwrap_or(0) {
            text += &format!("{}\n{}\n", self.name_of(place), self.table(place));
        }
        text += "Wrong rays, and the worst error in parts of its bound; * fails as expected; \
                 ! not as expected.\n";
        for place in 0..places.unwrap_or(0) {
            let of_place = || self.summary.iter().filter(|sum| sum.place == place);
            text += &format!("\n{}\n", self.name_of(place));
            text += &report::columns(
                [
                    "",
                    "passed",
                    "failed as expected",
                    "failed",
                    "passed unexpectedly",
                ],
                of_place().map(Sum::cells),
            );
            for sum in of_place() {
                if let Some(reason) = &sum.reason {
                    text += &format!("{} is not available: {reason}\n", sum.tier.name());
                }
            }
        }
        text += "\n";
        for row in self.cases.iter().filter(|row| !row.expected) {
            let place = self.name_of(row.place);
            let tier = row.tier.name();
            let (wrong, rays) = (row.wrong, row.rays);
            text += &format!("! {} in {tier} on {place}: ", row.id);
            text += &if row.pass {
                "it passes, and is expected to fail\n".to_string()
            } else {
                format!("{wrong} of {rays} rays are wrong\n")
            };
        }
        let count = self.cases.len();
        text += &if self.are_as_expected() {
            format!("All {count} outcomes are as expected")
        } else {
            let unexpected = self.cases.iter().filter(|row| !row.expected).count();
            format!("{unexpected} of {count} outcomes are not as expected")
        };
        text + &format!(", {:.1} s\n", self.seconds)
    }

    /// The cases on one backend, a column for each tier that it has.
    fn table(&self, place: usize) -> String {
        let tiers: Vec<Accuracy> = self
            .summary
            .iter()
            .filter(|sum| sum.available && sum.place == place)
            .map(|sum| sum.tier)
            .collect();
        let mut head = vec!["case".to_string(), "rays".into()];
        // The marks are not what a heading stands over.
        head.extend(tiers.iter().map(|tier| format!("{}  ", tier.name())));
        let mut rows: Vec<Vec<String>> = Vec::new();
        for row in self.cases.iter().filter(|row| row.place == place) {
            if rows.last().is_none_or(|last| last[0] != row.id) {
                rows.push(vec![row.id.into(), row.rays.to_string()]);
            }
            if let Some(last) = rows.last_mut() {
                last.push(row.cell());
            }
        }
        report::columns_of(head, rows)
    }
}

/// What a case is.
#[derive(Serialize)]
struct Entry {
    id: &'static str,
    name: &'static str,
    sets_up: &'static str,
    danger: &'static str,
    demands: Vec<String>,
    expected_to_fail: &'static [Accuracy],
    needs_denormals: &'static [Accuracy],
}

#[derive(Serialize)]
struct Entries {
    cases: Vec<Entry>,
}

/// What the cases are.
pub(super) fn listed(cases: &[&'static Case], as_json: bool) -> String {
    let entries = cases.iter().map(|case| Entry {
        id: case.id,
        name: case.name,
        sets_up: case.sets_up,
        danger: case.danger,
        demands: case.demands.iter().map(|one| one.describe()).collect(),
        expected_to_fail: case.fails,
        needs_denormals: case.needs_denormals(),
    });
    if as_json {
        let cases = entries.collect();
        return report::json(&Entries { cases });
    }
    let text = |entry: Entry| {
        let fails = entry.expected_to_fail.iter().map(|tier| tier.name());
        let fails: Vec<&str> = fails.collect();
        let fails = if fails.is_empty() {
            "none".into()
        } else {
            fails.join(", ")
        };
        format!(
            "{}: {}\n  {}\n  danger: {}\n  demands: {}\n  expected to fail: {fails}\n",
            entry.id,
            entry.name,
            entry.sets_up,
            entry.danger,
            entry.demands.join("; "),
        )
    };
    entries.map(text).collect::<Vec<_>>().join("\n")
}

//! `rayproof stability`.

pub(super) mod flags;
mod results;

use std::path::Path;
use std::time::Instant;

use self::flags::StabilityArguments;
use self::results::{Results, Row, Sum};
use super::Outcome;
use super::flags::Common;
use super::progress::Progress;
use super::report;
use rayproof::error::{Error, Result};
use rayproof::frame::{check_writable, write_rgb8};
use rayproof::render::Backend;
use rayproof::stability::view::View;
use rayproof::stability::{Case, Station, try_case};
use rayproof::watch::Watch;

/// Tries the hard cases in every tier on every backend.
pub(super) fn run(arguments: &StabilityArguments, common: &Common) -> Result<Outcome> {
    let cases = arguments.cases()?;
    if arguments.list {
        report::print(&results::listed(&cases, common.json))?;
        return Ok(Outcome::Done);
    }
    let view = arguments.view()?;
    if let Some((path, _)) = view {
        check_writable(path)?;
    }
    let backends = arguments.backends()?;
    if let Some((path, view)) = view {
        draw(view, path, &stations(arguments, &backends), common)?;
        return Ok(Outcome::Done);
    }
    let mut results = Results {
        rounds: arguments.rounds(),
        seconds: 0.0,
        cases: Vec::new(),
        summary: sums(arguments, &backends),
    };
    let started = Instant::now();
    let progress = Progress::new(common, "hard cases");
    for (number, &case) in cases.iter().enumerate() {
        let part = Part {
            of: &progress,
            number,
            parts: cases.len(),
        };
        results.try_case(case, &stations(arguments, &backends), &part)?;
    }
    drop(progress);
    results.seconds = started.elapsed().as_secs_f64();
    if common.json {
        report::print(&report::json(&results))?;
    } else if !common.quiet {
        report::print(&results.text())?;
    }
    Ok(if results.are_as_expected() {
        Outcome::Done
    } else {
        Outcome::FellShort
    })
}

/// Writes what a case looks like in each tier, side by side, on the last of the backends.
fn draw(view: &View, path: &Path, stations: &[Station<'_>], common: &Common) -> Result<()> {
    let Some(last) = stations.last() else {
        return Err(Error::Usage("no backend has such a tier".into()));
    };
    let on_last = |station: &&Station<'_>| std::ptr::eq(station.backend, last.backend);
    let stations: Vec<Station<'_>> = stations.iter().filter(on_last).copied().collect();
    let progress = Progress::new(common, view.id);
    let (pixels, [width, height]) = view.side_by_side(&stations, &progress)?;
    write_rgb8(path, width, height, &pixels)
}

/// The tiers that each backend has.
fn stations<'a>(arguments: &StabilityArguments, backends: &'a [Backend]) -> Vec<Station<'a>> {
    let tiers = arguments.tiers();
    let stations = backends
        .iter()
        .flat_map(|backend| tiers.iter().map(move |&tier| Station { backend, tier }));
    stations
        .filter(|station| station.backend.lacks(station.tier).is_none())
        .collect()
}

/// A sum for each tier on each backend, those that it lacks among them.
fn sums(arguments: &StabilityArguments, backends: &[Backend]) -> Vec<Sum> {
    let tiers = arguments.tiers();
    let sum = |backend, tier| Sum::of(&Station { backend, tier });
    backends
        .iter()
        .flat_map(|backend| tiers.iter().map(move |&tier| sum(backend, tier)))
        .collect()
}

impl Results {
    /// Tries a case and takes it in.
    fn try_case(
        &mut self,
        case: &'static Case,
        stations: &[Station<'_>],
        watch: &dyn Watch,
    ) -> Result<()> {
        let verdicts = try_case(case, stations, self.rounds, watch)?;
        for (station, verdict) in stations.iter().zip(verdicts) {
            let row = Row::of(station, &verdict);
            let own = |sum: &&mut Sum| sum.is_of(&row);
            if let Some(sum) = self.summary.iter_mut().find(own) {
                sum.add(&row);
            }
            self.cases.push(row);
        }
        Ok(())
    }
}

/// The progress of one of several parts.
struct Part<'a> {
    of: &'a Progress,
    number: usize,
    parts: usize,
}

impl Watch for Part<'_> {
    fn progress(&self, done: f64) {
        self.of
            .progress((self.number as f64 + done) / self.parts as f64);
    }

    fn cancelled(&self) -> bool {
        self.of.cancelled()
    }
}

//! `rayproof stability`.

pub(super) mod flags;
mod results;

use std::path::Path;
use std::time::Instant;

use serde::Serialize;

use self::flags::StabilityArguments;
use self::results::{Results, Row, Sum};
use super::Outcome;
use super::flags::Common;
use super::progress::Progress;
use super::report;
use rayproof::error::{Error, Result};
use rayproof::frame::{check_writable, write_rgb8};
use rayproof::render::{Accuracy, Backend};
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
    let asked = asked(arguments, &backends);
    let is_there = |(_, station): &&(usize, Station<'_>)| station.lacks().is_none();
    let stations: Vec<_> = asked.iter().filter(is_there).copied().collect();
    if stations.is_empty() {
        let reasons: Vec<String> = asked.iter().filter_map(|(_, at)| at.lacks()).collect();
        return Err(Error::Usage(reasons.join("; ")));
    }
    if let Some((path, view)) = view {
        draw(view, path, &stations, common)?;
        return Ok(Outcome::Done);
    }
    let mut results = Results {
        rounds: arguments.rounds(),
        seconds: 0.0,
        cases: Vec::new(),
        summary: asked
            .iter()
            .map(|(place, at)| Sum::of(*place, at))
            .collect(),
    };
    let started = Instant::now();
    let progress = Progress::new(common, "hard cases");
    for (number, &case) in cases.iter().enumerate() {
        let part = Part {
            of: &progress,
            number,
            parts: cases.len(),
        };
        results.try_case(case, &stations, &part)?;
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

/// What is told of a picture.
#[derive(Serialize)]
struct Drawn<'a> {
    case: &'a str,
    file: String,
    tiers: Vec<Accuracy>,
    width: u32,
    height: u32,
}

/// Writes what a case looks like in each tier, side by side, on the last of the backends.
fn draw(
    view: &View,
    path: &Path,
    stations: &[(usize, Station<'_>)],
    common: &Common,
) -> Result<()> {
    let last = stations.iter().map(|(place, _)| *place).max();
    let on_last = stations.iter().filter(|(place, _)| Some(*place) == last);
    let stations: Vec<Station<'_>> = on_last.map(|(_, station)| *station).collect();
    let progress = Progress::new(common, view.id);
    let (pixels, [width, height]) = view.side_by_side(&stations, &progress)?;
    write_rgb8(path, width, height, &pixels)?;
    if common.json {
        report::print(&report::json(&Drawn {
            case: view.id,
            file: path.display().to_string(),
            tiers: stations.iter().map(|station| station.tier).collect(),
            width,
            height,
        }))?;
    }
    Ok(())
}

/// Each tier asked for on each backend, and which backend that is; those that it lacks too.
fn asked<'a>(arguments: &StabilityArguments, backends: &'a [Backend]) -> Vec<(usize, Station<'a>)> {
    let tiers = arguments.tiers();
    let of_backend = |(place, backend): (usize, &'a Backend)| {
        let station = move |tier| (place, Station { backend, tier });
        tiers.clone().into_iter().map(station)
    };
    backends.iter().enumerate().flat_map(of_backend).collect()
}

impl Results {
    /// Tries a case and takes it in.
    fn try_case(
        &mut self,
        case: &'static Case,
        stations: &[(usize, Station<'_>)],
        watch: &dyn Watch,
    ) -> Result<()> {
        let only: Vec<Station<'_>> = stations.iter().map(|(_, station)| *station).collect();
        let verdicts = try_case(case, &only, self.rounds, watch)?;
        for ((place, station), verdict) in stations.iter().zip(verdicts) {
            let row = Row::of(*place, station, &verdict);
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

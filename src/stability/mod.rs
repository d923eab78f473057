//! Hard cases: where ray tracers break, tried on every tier and backend.
//!
//! [`FAMILIES`] is the catalogue. A [`Case`] says what it sets up, why careless code fails,
//! what it demands and which tiers are expected to fail. Its [`Trial`] has the scenes, rays
//! that are aimed where a decision is hard, and the exact answers; it is run on a
//! [`Subject`], a tier at a backend, and gives a [`Tally`]. A case that falls short is a
//! defect, and so is an expected failure that does not fail: the expectation is wrong then.
//!
//! [`trials`] has the kinds of trials; [`shapes`] and [`aim`] are what they are made of; a
//! [`view`] shows what a case looks like. The families are modules of their own.

pub mod aim;
pub mod axes;
pub mod case;
pub mod demand;
pub mod residual;
pub mod shapes;
pub mod subject;
pub mod tally;
pub mod trials;
pub mod view;

mod arithmetic;
mod bounds;
mod flat_shapes;
mod shading;
mod sphere;
mod triangle;

pub use case::{Case, Family, Trial, Verdict};
pub use demand::Demand;
pub use subject::{Station, Subject};
pub use tally::Tally;

use crate::error::{Error, Result};
use crate::random::Numbers;
use crate::watch::Watch;

/// The catalogue, in the order in which it is read.
pub const FAMILIES: &[Family] = &[
    sphere::FAMILY,
    flat_shapes::FAMILY,
    triangle::FAMILY,
    bounds::FAMILY,
    shading::FAMILY,
    arithmetic::FAMILY,
];

/// Rays of a round, where a rate is bounded.
pub const RAYS: usize = 100_000;

/// The cases of the catalogue.
pub fn catalogue() -> impl Iterator<Item = &'static Case> {
    FAMILIES.iter().flat_map(Family::cases)
}

/// Tries a case so many times, each time with other rays, at the stations that have its tier.
///
/// # Errors
///
/// [`Error::Interrupted`] when `watch` says so, and those of the backends.
pub fn try_case(
    case: &'static Case,
    stations: &[Station<'_>],
    rounds: u32,
    watch: &dyn Watch,
) -> Result<Vec<Verdict>> {
    let mut verdicts: Vec<Verdict> = stations
        .iter()
        .map(|station| Verdict {
            case,
            tier: station.tier,
            is_expected_to_fail: case.is_expected_to_fail_at(station),
            tally: Tally::default(),
        })
        .collect();
    let rounds = if case.is_random { rounds } else { 1 };
    let parts = f64::from(rounds) * (1 + stations.len()) as f64;
    let mut done = 0;
    for round in 0..rounds {
        // Another case with the same set-up has other rays.
        let mut numbers = Numbers(u64::from(round));
        for byte in case.id.bytes() {
            numbers.0 = numbers.next() ^ u64::from(byte);
        }
        let trial = (case.trial)(&mut numbers, case.demands)?;
        done += 1;
        for (station, verdict) in stations.iter().zip(&mut verdicts) {
            watch.progress(f64::from(done) / parts);
            if watch.cancelled() {
                return Err(Error::Interrupted);
            }
            verdict.tally.add(trial.run(station)?);
            done += 1;
        }
    }
    watch.progress(1.0);
    Ok(verdicts)
}

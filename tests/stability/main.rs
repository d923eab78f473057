//! The catalogue of hard cases: it comes out as it says, and each case can fail.

#[path = "../common/mod.rs"]
mod common;

mod broken;
mod broken_flat;
mod broken_round;
mod controls;

use rayproof::stability::{Station, catalogue, try_case};
use rayproof::{Accuracy, Backend, Unwatched};

#[test]
fn every_case_comes_out_as_expected() {
    let backends = [Backend::Cpu(None), Backend::Gpu(Box::new(common::gpu()))];
    let mut unexpected = Vec::new();
    for case in catalogue() {
        for backend in &backends {
            let stations = Accuracy::ALL.map(|tier| Station { backend, tier });
            for verdict in try_case(case, &stations, 1, &Unwatched).unwrap() {
                let (name, tier, tally) = (backend.name(), verdict.tier.name(), verdict.tally);
                let line = format!("{} {name} {tier}: {tally:?}", case.id);
                println!("{line}");
                if !verdict.is_as_expected() {
                    unexpected.push(line);
                }
            }
        }
    }
    assert!(unexpected.is_empty(), "{unexpected:#?}");
}

//! The catalogue of hard cases.

#[path = "../common/mod.rs"]
mod common;

use rayproof::stability::{Station, catalogue, try_case};
use rayproof::{Accuracy, Backend, Unwatched};

#[test]
fn every_case_comes_out_as_expected() {
    let backends = [Backend::Cpu(None), Backend::Gpu(Box::new(common::gpu()))];
    for case in catalogue() {
        for backend in &backends {
            let stations = Accuracy::ALL.map(|tier| Station { backend, tier });
            for verdict in try_case(case, &stations, 1, &Unwatched).unwrap() {
                println!(
                    "{} {} {}: {:?} {}",
                    case.id,
                    backend.name(),
                    verdict.tier.name(),
                    verdict.tally,
                    verdict.is_as_expected()
                );
            }
        }
    }
}

//! The catalogue of hard cases: it comes out as it says, and each case can fail.

#[path = "../common/mod.rs"]
mod common;

mod broken;
mod broken_boxes;
mod broken_flat;
mod broken_round;
mod broken_shading;
mod broken_straight;
mod controls;
mod document;

use std::collections::BTreeSet;
use std::sync::OnceLock;

use rayproof::stability::case::NEED_DENORMALS;
use rayproof::stability::{Case, Station, Tally, catalogue, try_case};
use rayproof::{Accuracy, Backend, Unwatched};

/// How a case came out.
struct Outcome {
    case: &'static Case,
    tier: Accuracy,
    backend: &'static str,
    tally: Tally,
    is_as_expected: bool,
}

impl Outcome {
    fn is_on_cpu(&self) -> bool {
        self.backend == "cpu"
    }
}

/// The whole catalogue, on the CPU and on the GPU.
fn outcomes() -> &'static [Outcome] {
    static OUTCOMES: OnceLock<Vec<Outcome>> = OnceLock::new();
    OUTCOMES.get_or_init(|| {
        let backends = [Backend::Cpu(None), Backend::Gpu(Box::new(common::gpu()))];
        let mut outcomes = Vec::new();
        for case in catalogue() {
            for backend in &backends {
                let stations = Accuracy::ALL.map(|tier| Station { backend, tier });
                let verdicts = try_case(case, &stations, 1, &Unwatched).unwrap();
                outcomes.extend(verdicts.into_iter().map(|verdict| Outcome {
                    case,
                    tier: verdict.tier,
                    backend: backend.name(),
                    is_as_expected: verdict.is_as_expected(),
                    tally: verdict.tally,
                }));
            }
        }
        outcomes
    })
}

#[test]
fn every_case_comes_out_as_expected() {
    let mut unexpected = Vec::new();
    for Outcome {
        case,
        tier,
        backend,
        tally,
        is_as_expected,
    } in outcomes()
    {
        let line = format!("{} {backend} {}: {tally:?}", case.id, tier.name());
        println!("{line}");
        if !is_as_expected {
            unexpected.push(line);
        }
    }
    assert!(unexpected.is_empty(), "{unexpected:#?}");
}

#[test]
fn the_gpu_is_as_wrong_as_the_cpu() {
    let of = |is_cpu| {
        outcomes()
            .iter()
            .filter(move |one| one.is_on_cpu() == is_cpu)
    };
    for (cpu, gpu) in of(true).zip(of(false)) {
        assert_eq!((cpu.case.id, cpu.tier), (gpu.case.id, gpu.tier));
        // The textbook's boxes are not padded, so a tree may lose what it likes.
        if cpu.tier != Accuracy::Textbook && cpu.case.id != "arithmetic/odd-rays-in-time" {
            let (id, tier) = (cpu.case.id, cpu.tier.name());
            assert_eq!(cpu.tally, gpu.tally, "{id} in {tier}");
        }
    }
}

#[test]
fn ids_are_those_of_their_families_and_differ() {
    let ids: BTreeSet<&str> = catalogue().map(|case| case.id).collect();
    for (id, _) in NEED_DENORMALS {
        assert!(ids.contains(id), "{id}");
    }
    assert_eq!(ids.len(), catalogue().count());
    for family in rayproof::stability::FAMILIES {
        for case in family.cases() {
            assert_eq!(case.id.split('/').next(), Some(family.name), "{}", case.id);
        }
    }
}

/// What f32 cannot resolve it still gets right for the most part; the textbook, the control, not.
#[test]
fn where_f32_falls_short_it_does_so_seldom() {
    for (id, most) in [("sphere/far-1e6", 0.02), ("sphere/far-1e7", 0.25)] {
        for one in outcomes().iter().filter(|one| one.case.id == id) {
            let share = one.tally.wrong as f64 / one.tally.rays as f64;
            match one.tier {
                Accuracy::Textbook => assert!(share > most, "{id}: {share}"),
                _ => assert!(share < most, "{id}: {share}"),
            }
        }
    }
}

#[test]
fn the_textbook_fails_at_least_thirty() {
    let failed = catalogue().filter(|case| case.is_expected_to_fail(Accuracy::Textbook));
    assert!(failed.count() >= 30);
}

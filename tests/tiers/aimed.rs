//! Lists of rays that are aimed where a decision is hard.

use rayproof::accuracy::truth::rounded_rays;
use rayproof::accuracy::{Truths, Widths};
use rayproof::bounds::Bounds;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::found::Found;
use rayproof::kernel::camera::Ray;
use rayproof::oracle::Truth;
use rayproof::{Accuracy, Backend, Unwatched};

use super::common::aimed::{AIMS, aimed_rays, hard_scene};
use super::common::scene;
use super::{HARD, PICTURES, backends, differing_ids, thorough};

/// The margin from which on a ray is clear in f64.
const CLEAR: f64 = 1e-12;

pub fn hard_flat() -> Flat<f64> {
    flatten(&hard_scene(false, 1.0))
}

/// Fails where two lists name another primitive, and shows where.
fn assert_same(case: &str, rays: &[Ray<f32>], left: &[Found], right: &[Found]) {
    let differing = differing_ids(left, right);
    let shown: Vec<String> = differing
        .iter()
        .take(8)
        .map(|&index| {
            let aim = AIMS[index % AIMS.len()].0;
            let (left, right) = (left[index], right[index]);
            format!("{index}, {aim}: {left:?}, {right:?}, {:?}", rays[index])
        })
        .collect();
    assert!(
        differing.is_empty(),
        "{case}: {} of {} differ: {shown:#?}",
        differing.len(),
        rays.len()
    );
}

fn trace(
    widths: &Widths,
    backend: &Backend,
    accuracy: Accuracy,
    rays: &[Ray<f32>],
) -> (Vec<Found>, u64) {
    widths.trace_rays(backend, accuracy, rays).unwrap()
}

#[test]
fn adaptive_finds_what_double_finds() {
    let [cpu, gpu] = backends();
    let count = if thorough() { 2_500_000 } else { 25_000 };
    let on_gpu = count.min(250_000);
    let mut differing = 0;
    let mut again = 0;
    for (turned, scale) in HARD {
        let case = format!("turned: {turned}, scale {scale:e}");
        let widths = Widths::of(flatten(&hard_scene(turned, scale)), Bounds::Tree);
        let rays = aimed_rays(&widths.double, count, 42);
        let (double, _) = trace(&widths, &cpu, Accuracy::Double, &rays);
        let (adaptive, retraced) = trace(&widths, &cpu, Accuracy::Adaptive, &rays);
        again += retraced;
        assert_same(&case, &rays, &double, &adaptive);
        let (robust, _) = trace(&widths, &cpu, Accuracy::Robust, &rays);
        differing += differing_ids(&double, &robust).len();
        let part = &rays[..on_gpu];
        let (of_gpu, _) = trace(&widths, &gpu, Accuracy::Adaptive, part);
        assert!(of_gpu == adaptive[..on_gpu], "{case}: GPU and CPU");
    }
    // The controls: without bounds some of them go wrong, and not all are in doubt.
    assert!(differing > 1000, "{differing}");
    assert!(again < 4 * count as u64 * 4 / 5, "{again}");
}

/// Each tier on both backends.
#[test]
fn both_backends_find_the_same() {
    let [cpu, gpu] = backends();
    let widths = Widths::of(flatten(&hard_scene(true, 1.0)), Bounds::Tree);
    let rays = aimed_rays(&widths.double, 10_000, 3);
    for accuracy in [Accuracy::Robust, Accuracy::Extended, Accuracy::Double] {
        let [on_cpu, on_gpu] =
            [&cpu, &gpu].map(|backend| trace(&widths, backend, accuracy, &rays).0);
        assert_eq!(on_cpu, on_gpu, "{accuracy:?}");
        assert!(on_cpu.iter().filter(|found| found.id != u32::MAX).count() > 5000);
    }
}

/// Which rays are in doubt does not depend on the way through the scene.
#[test]
fn a_tree_changes_no_doubt() {
    let cpu = Backend::Cpu(None);
    for (turned, scale) in HARD {
        let of = |bounds| Widths::of(flatten(&hard_scene(turned, scale)), bounds);
        let [with, without] = [Bounds::Tree, Bounds::None].map(of);
        let rays = aimed_rays(&with.double, 20_000, 5);
        let [(with, again), (without, as_often)] =
            [with, without].map(|widths| trace(&widths, &cpu, Accuracy::Adaptive, &rays));
        assert_eq!(again, as_often);
        assert!(with == without);
        assert!(again > 1000 && again < 19_000, "the control: {again}");
    }
}

/// Rays with a margin that are decided wrong in a tier.
fn wrong(widths: &Widths, rays: &[Ray<f32>], truths: &[Truth], accuracy: Accuracy) -> usize {
    let (found, _) = trace(widths, &Backend::Cpu(None), accuracy, rays);
    let pairs = found.iter().zip(truths);
    pairs
        .filter(|(found, truth)| found.id != truth.id && truth.margin > CLEAR)
        .count()
}

/// Errors of the tiers on some rays, by the oracle.
fn errors(widths: &Widths, rays: &[Ray<f32>]) -> [usize; 5] {
    let exact: Vec<Ray<f64>> = rays.iter().map(|ray| ray.converted()).collect();
    let truths = Truths::of(&widths.double, &exact, &Unwatched).unwrap().0;
    Accuracy::ALL.map(|accuracy| wrong(widths, rays, &truths, accuracy))
}

/// Rays that are clear in f64 are decided right in f64, and adaptively.
#[test]
fn no_clear_ray_goes_wrong() {
    let count = if thorough() { 200_000 } else { 5000 };
    for (turned, scale) in HARD {
        let widths = Widths::of(flatten(&hard_scene(turned, scale)), Bounds::Tree);
        let rays = aimed_rays(&widths.double, count, 11);
        let [textbook, robust, _, others @ ..] = errors(&widths, &rays);
        assert_eq!(others, [0; 2], "turned: {turned}, scale {scale:e}");
        // The controls: in f32 rays go wrong that are clear in f64.
        assert!(robust > 0 && robust < count / 2, "{robust}");
        assert!(textbook > robust, "{textbook}, {robust}");
    }
}

/// The same for the rays of pictures.
#[test]
fn no_clear_ray_of_a_picture_goes_wrong() {
    for name in PICTURES {
        let flat = flatten(&scene(name).with_size(80, 60));
        let widths = Widths::of(flat, Bounds::Tree);
        let rays = rounded_rays(&widths.double);
        let [textbook, robust, _, others @ ..] = errors(&widths, &rays);
        assert_eq!(others, [0; 2], "{name}");
        assert!(robust < 50, "{name}: {robust}");
        // The control.
        if name == "far-sphere" {
            assert!(textbook > 500, "{textbook}");
        }
    }
}

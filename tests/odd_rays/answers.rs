//! What odd rays find.

use rayproof::accuracy::{BAND, Truths, Widths};
use rayproof::bounds::Bounds;
use rayproof::flatten::flatten;
use rayproof::found::Found;
use rayproof::kernel::camera::Ray;
use rayproof::layout::NO_HIT;
use rayproof::{Accuracy, Backend, Unwatched};

use super::common::aimed::hard_scene;
use super::common::gpu;
use super::common::random::Numbers;
use super::trees::scenes;
use super::{is_no_ray, odd_rays, ordinary_ray, spoilt, thorough};

/// A miss, or a hit at a finite t; of what is no ray, a miss.
fn assert_sound(case: &str, rays: &[Ray<f32>], found: &[Found]) {
    for (ray, found) in rays.iter().zip(found) {
        let missed = found.id == NO_HIT;
        let sound = missed || found.t > 0.0 && found.t.is_finite() && !is_no_ray(*ray);
        assert!(sound, "{case}: {ray:?} finds {found:?}");
    }
}

/// The same, but for what is below half of the least f32: a shader hands t on as a sum of f32.
fn same(cpu: &Found, gpu: &Found) -> bool {
    cpu == gpu || cpu.id == gpu.id && (cpu.t - gpu.t).abs() <= 2f64.powi(-150)
}

/// Of both backends, in a tier.
fn check(name: &str, widths: &Widths, backends: &[Backend; 2], accuracy: Accuracy) -> usize {
    let case = format!("{name}, {}", accuracy.name());
    let rays = odd_rays(5, if thorough() { 50_000 } else { 4000 });
    let [cpu, gpu] = backends.each_ref().map(|backend| {
        let found = widths.trace_rays(backend, accuracy, &rays).unwrap().0;
        assert_sound(&case, &rays, &found);
        found
    });
    let pairs = rays.iter().zip(cpu.iter().zip(&gpu));
    let differing: Vec<_> = pairs.filter(|(_, (cpu, gpu))| !same(cpu, gpu)).collect();
    assert!(
        differing.is_empty(),
        "{case}: {}: {:#?}",
        differing.len(),
        &differing[..differing.len().min(4)]
    );
    cpu.iter().filter(|found| found.id != NO_HIT).count()
}

#[test]
fn odd_rays_find_nothing_or_something_finite() {
    let backends = [Backend::Cpu(None), Backend::Gpu(Box::new(gpu()))];
    for (name, scene) in scenes() {
        let of = |bounds| Widths::of(flatten(&scene), bounds);
        let tree = of(Bounds::Tree);
        let mut hits = 0;
        let all = thorough() || name == "everything";
        for accuracy in Accuracy::ALL {
            // The textbook's tree loses hits, on the CPU others than on the GPU.
            let plain = accuracy == Accuracy::Textbook;
            if all && !plain || accuracy == Accuracy::Robust {
                hits += check(name, &tree, &backends, accuracy);
            }
        }
        if all {
            let plain = of(Bounds::None);
            for accuracy in Accuracy::ALL {
                hits += check(name, &plain, &backends, accuracy);
            }
        }
        // The control: not all odd rays are lost.
        assert!(hits > 50 || name == "without area", "{name}: {hits}");
    }
}

/// Tiny components beside ordinary ones, and no component at all: decided right where the
/// tier can tell.
#[test]
fn tiny_components_are_no_harder_than_others() {
    let backend = Backend::Cpu(None);
    let widths = Widths::of(flatten(&hard_scene(true, 1.0)), Bounds::Tree);
    let mut n = Numbers(8);
    let mut rays = Vec::new();
    for tiny in [0.0, -0.0, 1e-39, -1e-39, 1e-30, -1e-30, 1e-20, 1e-10] {
        for places in [0b001, 0b010, 0b100, 0b011, 0b101, 0b110] {
            rays.extend((0..100).map(|_| spoilt(ordinary_ray(&mut n), places << 3, tiny)));
        }
    }
    let exact: Vec<Ray<f64>> = rays.iter().map(|ray| ray.converted()).collect();
    let truths = Truths::of(&widths.double, &exact, &Unwatched).unwrap().0;
    let wrong = |accuracy, margin| {
        let found = widths.trace_rays(&backend, accuracy, &rays).unwrap().0;
        let pairs = found.iter().zip(&truths);
        let wrong = pairs.filter(|(found, truth)| found.id != truth.id && truth.margin > margin);
        wrong.count()
    };
    for accuracy in [Accuracy::Extended, Accuracy::Double, Accuracy::Adaptive] {
        assert_eq!(wrong(accuracy, 1e-12), 0, "{}", accuracy.name());
    }
    assert_eq!(wrong(Accuracy::Robust, BAND), 0);
    let hits = truths.iter().filter(|truth| truth.id != NO_HIT).count();
    assert!(hits > 2000, "{hits}");
}

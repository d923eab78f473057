//! What odd rays find.

use rayproof::accuracy::Widths;
use rayproof::bounds::Bounds;
use rayproof::flatten::flatten;
use rayproof::found::Found;
use rayproof::kernel::camera::Ray;
use rayproof::layout::NO_HIT;
use rayproof::{Accuracy, Backend};

use super::common::gpu;
use super::trees::scenes;
use super::{is_no_ray, odd_rays, thorough};

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

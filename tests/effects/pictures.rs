//! The picture of every effect of paths alone, of every pair and of all at once has the same
//! bits on GPU and CPU.

use rayproof::effects::{EFFECTS, Effect, Part};
use rayproof::gpu::device::Gpu;
use rayproof::render::{Accuracy, Backend, Rendering, render};
use rayproof::scene::Scene;
use rayproof::watch::Unwatched;

use crate::scenes::{call_for, plain_scene};

/// The effects of paths.
fn of_paths() -> Vec<&'static str> {
    let is_path = |effect: &&Effect| effect.part == Part::Path;
    EFFECTS
        .iter()
        .filter(is_path)
        .map(|effect| effect.name)
        .collect()
}

fn scene_with(names: &[&str]) -> Scene {
    let mut scene = plain_scene();
    for name in names {
        call_for(name, &mut scene);
    }
    scene
}

fn drawn(scene: &Scene, backend: &Backend) -> Rendering {
    render(scene, backend, Accuracy::Robust, &Unwatched).unwrap()
}

/// Renders a scene with these effects on both, and compares.
fn agree(names: &[&str], gpu: &Backend) {
    let scene = scene_with(names);
    let on_gpu = drawn(&scene, gpu);
    let on_cpu = drawn(&scene, &Backend::Cpu(None));
    for name in names {
        assert!(
            on_gpu.stats.effects.contains(name),
            "{name} is not called for"
        );
    }
    assert!(on_gpu.frame.has_bits_of(&on_cpu.frame), "{names:?}");
    assert_eq!(on_gpu.frame.non_finite_pixels(), 0, "{names:?}");
    assert_eq!(on_gpu.stats.noise, on_cpu.stats.noise, "{names:?}");
    assert_eq!(on_gpu.stats.faults, 0, "{names:?}");
}

fn gpu() -> Backend {
    let gpu = Gpu::open(None).expect("a Vulkan driver, such as mesa-vulkan-drivers");
    assert!(gpu.is_bit_exact());
    Backend::Gpu(Box::new(gpu))
}

#[test]
fn every_effect_alone_and_all_at_once() {
    let gpu = gpu();
    let names = of_paths();
    for name in &names {
        agree(&[name], &gpu);
    }
    agree(&names, &gpu);
}

/// Every second pair: the other half is for another thread.
fn pairs(parity: usize) {
    let gpu = gpu();
    let names = of_paths();
    for (index, one) in names.iter().enumerate() {
        for (other_index, other) in names.iter().enumerate().skip(index + 1) {
            if (index + other_index) % 2 == parity {
                agree(&[one, other], &gpu);
            }
        }
    }
}

#[test]
fn every_even_pair() {
    pairs(0);
}

#[test]
fn every_odd_pair() {
    pairs(1);
}

/// The control: each effect changes the picture.
#[test]
fn every_effect_is_seen() {
    let cpu = Backend::Cpu(None);
    let plain = drawn(&plain_scene(), &cpu);
    for name in of_paths() {
        let changed = drawn(&scene_with(&[name]), &cpu);
        assert!(!changed.frame.has_bits_of(&plain.frame), "{name}");
    }
}

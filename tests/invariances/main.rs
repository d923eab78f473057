//! What must not change a picture, and how it must change where it does.

#[path = "../common/mod.rs"]
mod common;
mod converge;
mod lengths;
mod mirror;
mod order;
mod scale;
mod translate;
mod winding;

use common::aimed::hard_scene;
use common::gpu;
use common::random::random_scene;
use glam::DVec3;
use rayproof::bounds::Bounds;
use rayproof::render::Settings;
use rayproof::scene::{Group, GroupBound, Light};
use rayproof::{Accuracy, Backend, Frame, Scene, Unwatched};

/// The tiers that promise something.
const TIERS: [Accuracy; 4] = [
    Accuracy::Robust,
    Accuracy::Extended,
    Accuracy::Double,
    Accuracy::Adaptive,
];

/// How many scenes are looked at on the CPU; the first of them on the GPU too.
fn seeds() -> std::ops::Range<u64> {
    let thorough = std::env::var_os("RAYPROOF_THOROUGH").is_some();
    0..if thorough { 100 } else { 3 }
}

fn gpu_backend() -> Backend {
    Backend::Gpu(Box::new(gpu()))
}

/// A scene with everything in it; two groups with volumes given by hand, that cut some off.
fn generated(seed: u64) -> Scene {
    let mut scene = random_scene(seed, 1.0);
    // More shapes, some in one place: those come last.
    scene
        .shapes
        .extend(hard_scene(true, 1.0).shapes.into_iter().take(3));
    let center = DVec3::new(0.5, -1.0, 0.25);
    let ball = GroupBound::Ball {
        center,
        radius: 6.0,
    };
    let cube = GroupBound::Box {
        low: center - 5.0,
        high: center + 4.0,
    };
    scene.groups = [(ball, 0..2), (cube, 3..6)]
        .map(|(bound, shapes)| Group {
            name: None,
            bound,
            parent: None,
            shapes,
        })
        .to_vec();
    scene
}

fn picture(scene: &Scene, backend: &Backend, accuracy: Accuracy, bounds: Bounds) -> Frame {
    scene.validate().unwrap();
    let settings = Settings {
        accuracy,
        bounds,
        forced: rayproof::effects::EffectSet::NONE,
    };
    rayproof::render(scene, backend, settings, &Unwatched)
        .unwrap()
        .frame
}

/// What a pixel shows, in bits; 0 and -0 count as the same.
fn bits_of(frame: &Frame, at: usize) -> [u32; 11] {
    let [r, g, b] = frame.color[at];
    let [nx, ny, nz] = frame.normal[at];
    let [px, py, pz] = frame.position[at];
    let numbers = [r, g, b, nx, ny, nz, px, py, pz, frame.depth[at]];
    let mut bits = [frame.id[at]; 11];
    for (bits, number) in bits.iter_mut().zip(numbers) {
        *bits = (number + 0.0).to_bits();
    }
    bits
}

/// Pixels in which two pictures differ.
fn different(left: &Frame, right: &Frame) -> usize {
    let pixels = 0..left.pixels();
    pixels
        .filter(|&at| bits_of(left, at) != bits_of(right, at))
        .count()
}

/// The scene with all points mapped: those of shapes by way of their transforms.
fn mapped(scene: &Scene, factor: DVec3, offset: DVec3) -> Scene {
    let place = |point: DVec3| point * factor + offset;
    let mut scene = scene.clone();
    scene.camera.eye = place(scene.camera.eye);
    scene.camera.target = place(scene.camera.target);
    // Only a mirror's signs matter to directions.
    scene.camera.up *= factor.signum();
    for shape in &mut scene.shapes {
        let linear = shape.transform.linear;
        shape.transform.linear = glam::DMat3::from_diagonal(factor) * linear;
        shape.transform.translate = place(shape.transform.translate);
    }
    for light in &mut scene.lights {
        match light {
            Light::Point { position, .. } => *position = place(*position),
            Light::Directional { direction, .. } => *direction *= factor.signum(),
            Light::Area { .. } => unreachable!("no scene of these tests has one"),
        }
    }
    for group in &mut scene.groups {
        match &mut group.bound {
            GroupBound::Auto => {}
            GroupBound::Ball { center, radius } => {
                *center = place(*center);
                *radius *= factor.x.abs();
            }
            GroupBound::Box { low, high } => {
                let (one, other) = (place(*low), place(*high));
                (*low, *high) = (one.min(other), one.max(other));
            }
        }
    }
    scene
}

/// Fails unless `change` changes nothing, on both backends and in every tier: `expected` makes
/// of the picture before the one after.
fn assert_holds(
    name: &str,
    change: impl Fn(&Scene) -> Scene,
    expected: impl Fn(&Frame) -> Frame,
    tiers: &[Accuracy],
    scene_of: impl Fn(u64) -> Scene,
) {
    let gpu = gpu_backend();
    let mut hits = 0;
    for seed in seeds() {
        let scene = scene_of(seed);
        let changed = change(&scene);
        for &accuracy in tiers {
            for bounds in [Bounds::Tree, Bounds::Scene] {
                let here = picture(&scene, &Backend::Cpu(None), accuracy, bounds);
                hits += here.id.iter().filter(|id| **id != u32::MAX).count();
                let expected = expected(&here);
                let there = picture(&changed, &Backend::Cpu(None), accuracy, bounds);
                let case = format!("{name}, seed {seed}, {}, {bounds:?}", accuracy.name());
                assert_eq!(different(&expected, &there), 0, "{case}");
                if seed == 0 && bounds == Bounds::Tree {
                    let there = picture(&changed, &gpu, accuracy, bounds);
                    assert_eq!(different(&expected, &there), 0, "{case}, on the GPU");
                }
            }
        }
    }
    assert!(hits > 1000 * seeds().count(), "only {hits} hits");
}

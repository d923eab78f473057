//! Pictures: GPU and CPU agree in every tier, and `adaptive` sees what `double` sees.

use rayproof::bounds::Bounds;
use rayproof::render::Settings;
use rayproof::{Accuracy, Backend, Frame, Scene, Unwatched};

use super::common::random::random_scene;
use super::common::{assert_same_bits, compare, scene};
use super::{PICTURES, backends};

fn render(scene: &Scene, backend: &Backend, accuracy: Accuracy, bounds: Bounds) -> (Frame, u64) {
    let settings = Settings {
        accuracy,
        bounds,
        forced: rayproof::effects::EffectSet::NONE,
    };
    let rendering = rayproof::render(scene, backend, settings, &Unwatched).unwrap();
    (rendering.frame, rendering.stats.retraced.unwrap_or(0))
}

/// Pixels in which two pictures show another primitive.
fn other_ids(left: &Frame, right: &Frame) -> usize {
    let pairs = left.id.iter().zip(&right.id);
    pairs.filter(|(left, right)| left != right).count()
}

/// Not the textbook's with a tree: its boxes are not padded, so which hits are lost depends on
/// the tree, and the CPU has one of its own.
#[test]
fn both_backends_agree_in_every_tier() {
    let [cpu, gpu] = backends();
    let mut changed = 0;
    for name in PICTURES {
        let scene = scene(name).with_size(120, 90);
        let mut robust = None;
        for accuracy in [
            Accuracy::Robust,
            Accuracy::Extended,
            Accuracy::Double,
            Accuracy::Adaptive,
        ] {
            let [(on_cpu, again), (on_gpu, again_on_gpu)] =
                [&cpu, &gpu].map(|backend| render(&scene, backend, accuracy, Bounds::Tree));
            assert_same_bits(&on_cpu, &on_gpu);
            assert_eq!(again, again_on_gpu, "{name}");
            assert!(again == 0 || accuracy == Accuracy::Adaptive);
            if accuracy == Accuracy::Robust {
                robust = Some(on_cpu);
                continue;
            }
            // The control: the tiers are not all the same.
            changed += compare(robust.as_ref().unwrap(), &on_cpu).different_pixels;
        }
        if name != "knot" {
            let [on_cpu, on_gpu] = [&cpu, &gpu]
                .map(|backend| render(&scene, backend, Accuracy::Textbook, Bounds::None).0);
            assert_same_bits(&on_cpu, &on_gpu);
        }
    }
    assert!(changed > 1000, "{changed}");
}

#[test]
fn adaptive_sees_what_double_sees() {
    let [cpu, gpu] = backends();
    let mut changed = 0;
    let mut again = 0;
    for name in PICTURES {
        let scene = scene(name).with_size(240, 180);
        let double = render(&scene, &cpu, Accuracy::Double, Bounds::Tree).0;
        for backend in [&cpu, &gpu] {
            let (adaptive, retraced) = render(&scene, backend, Accuracy::Adaptive, Bounds::Tree);
            assert_eq!(other_ids(&double, &adaptive), 0, "{name}");
            assert!(retraced < 240 * 180, "{name}: all are in doubt");
            again += retraced;
        }
        let textbook = render(&scene, &cpu, Accuracy::Textbook, Bounds::Tree).0;
        changed += other_ids(&double, &textbook);
    }
    // The controls: there was something to be seen otherwise, and to be in doubt.
    assert!(changed > 100, "{changed}");
    assert!(again > 100, "{again}");
}

#[test]
fn adaptive_sees_what_double_sees_at_every_scale() {
    let [cpu, gpu] = backends();
    let mut changed = 0;
    let mut hits = 0;
    for (seed, exponent) in (0..).zip([-6, -4, -3, -2, -1, 0, 0, 1, 2, 3, 4, 6]) {
        let scene = random_scene(seed, 10f64.powi(exponent));
        let on = |accuracy| render(&scene, &cpu, accuracy, Bounds::Tree).0;
        let double = on(Accuracy::Double);
        assert_eq!(
            other_ids(&double, &on(Accuracy::Adaptive)),
            0,
            "1e{exponent}"
        );
        if exponent % 3 == 0 {
            let on_gpu = render(&scene, &gpu, Accuracy::Adaptive, Bounds::Tree).0;
            assert_eq!(other_ids(&double, &on_gpu), 0, "1e{exponent} on the GPU");
        }
        changed += other_ids(&double, &on(Accuracy::Textbook));
        hits += double.id.iter().filter(|id| **id != u32::MAX).count();
    }
    // The controls.
    assert!(hits > 10_000, "{hits}");
    assert!(changed > 100, "{changed}");
}

/// One dispatch cannot search and go through so many lights: lavapipe would stop it.
#[test]
fn many_lights_are_not_lost_on_rays_in_doubt() {
    let mut scene = scene("shapes").with_size(8, 6);
    // Each ray is in doubt: every sphere is there twice.
    let twice = scene.shapes.clone();
    scene.shapes.extend(twice);
    let light = scene.lights[0];
    scene.lights = vec![light; 39_000];
    let [cpu, gpu] = backends();
    for accuracy in [Accuracy::Robust, Accuracy::Adaptive] {
        let [(on_cpu, _), (on_gpu, _)] =
            [&cpu, &gpu].map(|backend| render(&scene, backend, accuracy, Bounds::Tree));
        assert_same_bits(&on_cpu, &on_gpu);
    }
}

//! The tiers of paths of light.

use glam::DVec3;
use rayproof::Accuracy;
use rayproof::bounds::{Bounds, bound};
use rayproof::flatten::flatten;
use rayproof::kernel::integrator::sample_pixel;
use rayproof::kernel::tally::add_sample;
use rayproof::layout::{Pixel, Tally};
use rayproof::render::Backend;
use rayproof::scene::{Geometry, Light, Scene};
use rayproof::tier::Textbook;

use crate::common::{assert_same_bits, compare, gpu};
use crate::scenes::{matt, room, shape};
use crate::volumes::{by, grouped};

#[test]
fn tiers_show_the_same_on_both_backends() {
    let (cpu, gpu) = (Backend::Cpu(None), Backend::Gpu(Box::new(gpu())));
    let scene = grouped();
    let robust = by(&scene, &cpu, Accuracy::Robust, Bounds::Tree);
    for accuracy in [Accuracy::Extended, Accuracy::Double, Accuracy::Adaptive] {
        for bounds in [Bounds::Tree, Bounds::Spheres { levels: 1 }] {
            let [here, there] = [&cpu, &gpu].map(|backend| by(&scene, backend, accuracy, bounds));
            let comparison = compare(&here, &there);
            assert_eq!(comparison.different_pixels, 0, "{accuracy:?} {bounds:?}");
            // The control: it is not the picture of another tier.
            assert!(compare(&robust, &here).different_pixels > 0);
        }
    }
}

/// The textbook's primitives are not padded, so which hits a tree loses depends on the tree, and
/// the CPU has one of its own: see `tests/tiers/pictures.rs`. Without one there is no difference.
#[test]
fn textbook_paths_agree_without_a_tree() {
    let (cpu, gpu) = (Backend::Cpu(None), Backend::Gpu(Box::new(gpu())));
    for scene in [grouped(), room(64, 4, 2)] {
        for bounds in [Bounds::None, Bounds::Spheres { levels: 1 }] {
            let [here, there] =
                [&cpu, &gpu].map(|backend| by(&scene, backend, Accuracy::Textbook, bounds));
            let comparison = compare(&here, &there);
            assert_eq!(comparison.different_pixels, 0, "{bounds:?}");
        }
    }
}

/// With a tree, what the GPU finds is what the kernel finds by the same tree: the CPU's other tree
/// is all that may differ.
#[test]
fn textbook_paths_agree_by_the_same_tree() {
    let gpu = Backend::Gpu(Box::new(gpu()));
    for scene in [grouped(), room(64, 4, 2)] {
        let frame = by(&scene, &gpu, Accuracy::Textbook, Bounds::Tree);
        let mut flat = flatten::<Textbook>(&scene);
        bound(&mut flat, Bounds::Tree);
        let mut tracer = &flat;
        for (index, found) in (0..).zip(&frame.color) {
            let (mut sum, mut tally) = (Pixel::default(), Tally::default());
            for sample in 0..flat.samples {
                let (x, y) = (index % frame.width, index / frame.width);
                let taken = sample_pixel(&flat, &mut tracer, x, y, sample);
                add_sample(&mut sum, &mut tally, taken.color.into());
            }
            let mean = sum.color.map(|channel| channel / flat.samples as f32);
            assert_eq!(*found, mean, "{index}");
        }
    }
}

/// A ball so far away that two f32 and f64 see it differently, in as many lights.
fn far_ball(lights: usize) -> Scene {
    let far = 1e8;
    let ball = Geometry::Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };
    let light = Light::Directional {
        direction: DVec3::new(0.3, 1.0, 0.5),
        color: [1.0 / lights as f64; 3],
        shadow: false,
    };
    let mut scene = Scene {
        materials: vec![matt([0.8; 3])],
        shapes: vec![shape(ball, 0)],
        lights: vec![light; lights],
        ..Scene::default()
    }
    .with_size(16, 16);
    scene.camera.eye = DVec3::Z * far;
    scene.camera.target = DVec3::ZERO;
    scene.camera.fov_degrees = (2.5 / far).to_degrees();
    scene
}

/// Where a device has no f64, two f32 stand for them: with paths, and without where rays in doubt
/// cannot be traced again, for there are too many lights.
#[test]
fn adaptive_does_without_f64() {
    let mut device = gpu();
    device.give_up_f64().unwrap();
    assert!(device.lacks(Accuracy::Double).is_some());
    let without = Backend::Gpu(Box::new(device));
    let with = Backend::Gpu(Box::new(gpu()));
    let mut paths = far_ball(1);
    paths.integrator.samples = 4;
    paths.integrator.bounces = 1;
    for scene in [paths, far_ball(1001)] {
        let on = |backend, accuracy| by(&scene, backend, accuracy, Bounds::Tree);
        let found = on(&without, Accuracy::Adaptive);
        assert_same_bits(&found, &on(&with, Accuracy::Extended));
        // The control: it is not what f64 see.
        assert!(compare(&found, &on(&with, Accuracy::Adaptive)).different_pixels > 0);
    }
}

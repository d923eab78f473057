//! Volumes in lists: what they save is counted exactly, and no picture changes.

mod common;

use common::random::random_scene;
use common::{
    CHOICES, assert_bounds_change_nothing, changed, compare, gpu, mesh_scene, scene, sphere_ahead,
    white_scene,
};
use glam::DVec3;
use rayproof::bounds::{Bounds, bound, overfull_groups};
use rayproof::count::Counters;
use rayproof::flatten::flatten;
use rayproof::gpu::render::{Portions, render};
use rayproof::render::{Settings, count};
use rayproof::scene::mesh::Builtin;
use rayproof::scene::{Geometry, Group, GroupBound, Shape};
use rayproof::{Accuracy, Backend, Scene, Unwatched};

fn with(accuracy: Accuracy, bounds: Bounds) -> Settings {
    Settings {
        accuracy,
        bounds,
        forced: rayproof::effects::EffectSet::NONE,
    }
}

fn counters(backend: &Backend, accuracy: Accuracy, bounds: Bounds) -> Counters {
    let scene = scene("seed-spheres");
    count(&scene, backend, with(accuracy, bounds), &Unwatched)
        .unwrap()
        .sum()
}

/// The counts of the 2017 report's first test.
#[test]
fn counts_of_the_report() {
    let cpu = Backend::Cpu(None);
    let gpu = Backend::Gpu(Box::new(gpu()));
    let none = Counters {
        bound_tests: 0,
        bound_hits: 0,
        shape_tests: 72_000_000,
    };
    let scene = Counters {
        bound_tests: 2_000_000,
        bound_hits: 256_242,
        shape_tests: 9_224_712,
    };
    assert_eq!(counters(&cpu, Accuracy::Double, Bounds::None), none);
    assert_eq!(counters(&cpu, Accuracy::Double, Bounds::Scene), scene);
    assert_eq!(counters(&cpu, Accuracy::Robust, Bounds::None), none);
    assert_eq!(counters(&gpu, Accuracy::Robust, Bounds::None), none);
    let rounded = counters(&cpu, Accuracy::Robust, Bounds::Scene);
    assert_eq!(rounded.bound_hits, 256_242);
    assert_eq!(rounded, scene);
    for bounds in CHOICES {
        let on = |backend| counters(backend, Accuracy::Robust, bounds);
        assert_eq!(on(&gpu), on(&cpu), "{bounds:?}");
    }
}

/// Tight volumes need fewer tests than the report's.
#[test]
fn tight_volumes_save_more() {
    let total = |bounds| {
        let counters = counters(&Backend::Cpu(None), Accuracy::Double, bounds);
        counters.bound_tests + counters.shape_tests
    };
    let given = total(Bounds::Scene);
    assert_eq!(given, 11_224_712);
    let spheres = total(Bounds::Spheres { levels: 1 });
    // seed.md has 9,548,588 for spheres without padding, and 6,581,144 for boxes.
    assert!(spheres.abs_diff(9_548_588) < 20_000, "{spheres}");
    let boxes = total(Bounds::Boxes { levels: 1 });
    assert!(boxes.abs_diff(6_581_144) < 20_000, "{boxes}");
    assert!(total(Bounds::Spheres { levels: 3 }) < spheres);
    assert!(total(Bounds::Boxes { levels: 3 }) < boxes);
}

#[test]
fn seed_spheres() {
    assert_bounds_change_nothing(&scene("seed-spheres").with_size(400, 400), &CHOICES);
}

#[test]
fn shapes() {
    assert_bounds_change_nothing(&scene("shapes").with_size(200, 200), &CHOICES);
}

#[test]
fn seed_models() {
    assert_bounds_change_nothing(&scene("seed-models").with_size(100, 100), &CHOICES);
}

#[test]
fn knot() {
    assert_bounds_change_nothing(&scene("knot").with_size(12, 12), &CHOICES);
}

/// The random scene with its shapes, planes first, in nested groups.
fn grouped(seed: u64, scale: f64) -> Scene {
    let mut scene = random_scene(seed, scale);
    let is_plane = |shape: &Shape| matches!(shape.geometry, Geometry::Plane { .. });
    scene.shapes.sort_by_key(|shape| !is_plane(shape));
    let first = scene
        .shapes
        .iter()
        .take_while(|shape| is_plane(shape))
        .count();
    let last = scene.shapes.len();
    let third = (last - first) / 3;
    let group = |parent, shapes| Group {
        name: None,
        bound: GroupBound::Auto,
        parent,
        shapes,
    };
    scene.groups = vec![
        group(None, first..first + third),
        group(Some(0), first + third..first + 2 * third),
        group(Some(1), 0..0),
        group(None, first + 2 * third..last - 1),
    ];
    scene
}

#[test]
fn random_groups_at_every_scale() {
    for seed in 0..30 {
        let exponent = [-6, -3, 0, 3, 6][seed as usize % 5];
        let scene = grouped(seed, 10f64.powi(exponent));
        scene.validate().unwrap();
        for bounds in CHOICES {
            let here = format!("seed {seed}, scale 1e{exponent}, {bounds:?}");
            assert_eq!(changed::<f32>(&scene, bounds), 0, "{here}, f32");
            assert_eq!(changed::<f64>(&scene, bounds), 0, "{here}, f64");
        }
    }
}

/// A sphere of radius 1 at (0, 0, -3) in a group with a volume.
fn one_sphere(bound: GroupBound) -> Scene {
    Scene {
        groups: vec![Group {
            name: Some("lone".into()),
            bound,
            parent: None,
            shapes: 0..1,
        }],
        ..white_scene(vec![sphere_ahead()])
    }
    .with_size(64, 64)
}

/// The control: a volume that is too small cuts the picture, and is warned of; one that
/// just holds its shape does neither.
#[test]
fn a_volume_that_is_too_small_is_noticed() {
    let center = DVec3::new(0.0, 0.0, -3.0);
    let ball = |radius| one_sphere(GroupBound::Ball { center, radius });
    let cube = |half| {
        one_sphere(GroupBound::Box {
            low: center - half,
            high: center + half,
        })
    };
    for scene in [
        ball(1.0),
        cube(1.0),
        ball(1.5),
        cube(1.5),
        one_sphere(GroupBound::Auto),
    ] {
        assert_eq!(changed::<f32>(&scene, Bounds::Scene), 0);
        assert_eq!(changed::<f64>(&scene, Bounds::Scene), 0);
        assert!(overfull_groups(&scene).is_empty());
    }
    // A ray at the sphere's outline enters the cube nearer to the camera.
    for (scene, by) in [(ball(0.9), 0.1), (cube(0.5), 0.5)] {
        assert!(changed::<f32>(&scene, Bounds::Scene) > 10);
        assert_eq!(changed::<f32>(&scene, Bounds::Spheres { levels: 1 }), 0);
        let warnings = overfull_groups(&scene);
        assert_eq!(warnings.len(), 1);
        assert!(warnings[0].contains("shape 0 (sphere)"), "{warnings:?}");
        let told = format!("\"lone\" by {by}");
        assert!(warnings[0].contains(&told), "{warnings:?}");
    }
}

/// More triangles in one ball than lavapipe loops: right all the same, for a ray goes
/// through the list in several dispatches.
#[test]
fn two_hundred_thousand_triangles_in_one_ball() {
    let scene = mesh_scene(Builtin::Icosphere, 200_000, 24);
    let backend = Backend::Gpu(Box::new(gpu()));
    let on = |bounds| {
        rayproof::render(&scene, &backend, with(Accuracy::Robust, bounds), &Unwatched)
            .unwrap()
            .frame
    };
    let frame = on(Bounds::Spheres { levels: 1 });
    assert_eq!(compare(&frame, &on(Bounds::Tree)).different_pixels, 0);
    assert!(frame.id.iter().any(|&id| id != u32::MAX && id > 150_000));
}

/// However small the dispatches, the picture is the same.
#[test]
fn dispatches_do_not_show() {
    let mut flat = flatten::<f32>(&scene("seed-models").with_size(40, 40));
    bound(&mut flat, Bounds::Spheres { levels: 2 });
    let on_gpu = |primitives_per_dispatch| {
        let portions = Portions {
            primitives_per_dispatch,
            ..Portions::default()
        };
        let mut pixels = Vec::new();
        render(&gpu(), &flat, portions, &Unwatched, &mut |_, rows| {
            pixels.extend_from_slice(rows);
        })
        .unwrap();
        pixels
    };
    assert_eq!(on_gpu(300), on_gpu(60_000));
}

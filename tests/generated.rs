//! Generated scenes, made of awkward numbers: no choice of volumes changes a bit.

mod common;

use common::{BRUTE_FORCE, CHOICES, changed, gpu, white_scene};
use glam::{DMat3, DVec3};
use proptest::prelude::*;
use proptest::sample::select;
use rayproof::bounds::{Bounds, bound};
use rayproof::flatten::flatten;
use rayproof::render::Settings;
use rayproof::scene::{Geometry, Group, GroupBound, PixelSampling, Shape, Transform};
use rayproof::{Accuracy, Backend, Scene, Unwatched, cpu};

/// Coordinates reach so far, and spheres and disks by as much as 1 further.
const REACH: f64 = 2.0;

/// Mostly the same few numbers, so that centroids coincide, boxes are flat and rays run
/// along their faces.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => select(vec![-1.0, 0.0, 0.5, 1.0, REACH]),
        1 => -REACH..REACH,
    ]
}

fn point() -> impl Strategy<Value = DVec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from_array)
}

fn shape() -> impl Strategy<Value = Geometry> {
    let radius = || prop_oneof![select(vec![0.5, 1.0]), 0.001..1.0];
    let axis = prop_oneof![
        select(vec![DVec3::X, DVec3::Y, DVec3::Z]),
        point().prop_filter("no direction", |v| v.length() > 0.1),
    ];
    prop_oneof![
        (point(), radius()).prop_map(|(center, radius)| Geometry::Sphere { center, radius }),
        (point(), axis, radius()).prop_map(|(center, normal, radius)| Geometry::Disk {
            center,
            normal,
            radius
        }),
        [point(), point(), point()].prop_map(|vertices| Geometry::Triangle { vertices }),
    ]
}

/// By itself, or by hand: a ball with room, or a box that just holds everything.
fn group_bound() -> impl Strategy<Value = GroupBound> {
    let all = DVec3::splat(REACH + 1.0);
    select(vec![
        GroupBound::Auto,
        GroupBound::Ball {
            center: DVec3::ZERO,
            radius: 2.0 * all.length(),
        },
        GroupBound::Box {
            low: -all,
            high: all,
        },
    ])
}

fn scaled(bound: GroupBound, scale: f64) -> GroupBound {
    match bound {
        GroupBound::Auto => GroupBound::Auto,
        GroupBound::Ball { center, radius } => GroupBound::Ball {
            center: center * scale,
            radius: radius * scale,
        },
        GroupBound::Box { low, high } => GroupBound::Box {
            low: low * scale,
            high: high * scale,
        },
    }
}

/// Shapes in two groups, one in the other, and outside of them; seen from a coordinate's
/// plane, with rays along the axes among others.
fn scene() -> impl Strategy<Value = Scene> {
    let shapes = prop::collection::vec(shape(), 3..24);
    let eye = (coordinate(), coordinate(), select(vec![0.0, 1.0, 6.0]));
    let bounds = [group_bound(), group_bound()];
    (shapes, eye, bounds, -6..=6_i32).prop_map(|(shapes, eye, bounds, exponent)| {
        let scale = 10f64.powi(exponent);
        let placed = |geometry| Shape {
            geometry,
            transform: Transform {
                linear: DMat3::from_diagonal(DVec3::splat(scale)),
                translate: DVec3::ZERO,
            },
            material: 0,
            velocity: DVec3::ZERO,
        };
        let mut scene = white_scene(shapes.into_iter().map(placed).collect()).with_size(16, 16);
        scene.camera.eye = DVec3::new(eye.0, eye.1, eye.2) * scale;
        scene.camera.target = scene.camera.eye - DVec3::Z * scale;
        scene.camera.fov_degrees = 60.0;
        scene.camera.sampling = PixelSampling::Corner;
        let third = scene.shapes.len() / 3;
        let group = |bound, parent, shapes| Group {
            name: None,
            bound: scaled(bound, scale),
            parent,
            shapes,
        };
        scene.groups = vec![
            group(bounds[0], None, 0..third),
            group(bounds[1], Some(0), third..2 * third),
        ];
        scene
    })
}

/// Pixels that the CPU traces otherwise through its own tree.
fn changed_by_the_wide_tree(scene: &Scene) -> usize {
    let on_cpu = |bounds| {
        let mut flat = flatten::<f32>(scene);
        bound(&mut flat, bounds);
        let mut pixels = Vec::new();
        cpu::render(&flat, None, &Unwatched, &mut |_, rows| {
            pixels.extend(rows.iter().map(|pixel| (pixel.id, pixel.depth.to_bits())));
        })
        .unwrap();
        pixels
    };
    let pairs = on_cpu(Bounds::None).into_iter().zip(on_cpu(Bounds::Tree));
    pairs.filter(|(plain, bounded)| plain != bounded).count()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn no_volume_changes_a_bit(scene in scene()) {
        prop_assume!(scene.validate().is_ok());
        for bounds in CHOICES {
            prop_assert_eq!(changed::<f32>(&scene, bounds), 0, "{:?}, f32", bounds);
            prop_assert_eq!(changed::<f64>(&scene, bounds), 0, "{:?}, f64", bounds);
        }
        prop_assert_eq!(changed_by_the_wide_tree(&scene), 0);
    }
}

/// A few on the GPU, where each scene is a shader of its own.
#[test]
fn nor_on_the_gpu() {
    let backend = Backend::Gpu(Box::new(gpu()));
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let mut hits = 0;
    for _ in 0..6 {
        let scene = loop {
            let tree = scene().new_tree(&mut runner).unwrap();
            let scene = proptest::strategy::ValueTree::current(&tree);
            if scene.validate().is_ok() {
                break scene;
            }
        };
        let frame = |settings| {
            let rendering = rayproof::render(&scene, &backend, settings, &Unwatched);
            rendering.unwrap().frame
        };
        let plain = frame(BRUTE_FORCE);
        hits += plain.id.iter().filter(|id| **id != u32::MAX).count();
        for bounds in CHOICES {
            let accuracy = Accuracy::Robust;
            let bounded = frame(Settings {
                accuracy,
                bounds,
                forced: rayproof::effects::EffectSet::NONE,
            });
            assert!(plain.has_bits_of(&bounded), "{bounds:?}: {scene:#?}");
        }
    }
    // The control: there is something to be lost.
    assert!(hits > 100, "{hits}");
}

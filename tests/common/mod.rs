//! What several tests need.

#![allow(dead_code, reason = "each test uses a part")]

pub mod aimed;
pub mod random;

use std::sync::Arc;

use glam::{DMat3, DVec3};
use rayproof::bounds::{Bounds, bound};
use rayproof::flatten::flatten;
use rayproof::gpu::device::Gpu;
use rayproof::kernel::hit::GIVEN_UP;
use rayproof::kernel::real::Real;
use rayproof::kernel::trace::trace_pixel;
use rayproof::layout::Pixel;
use rayproof::render::Settings;
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{Geometry, Mesh, PixelSampling, Shape, Transform};
use rayproof::{Accuracy, Backend, Comparison, Frame, Scene, Tolerance, Unwatched};

/// The best adapter; without one the test fails, for a check that was not made
/// is no check.
pub fn gpu() -> Gpu {
    Gpu::open(None).unwrap_or_else(|error| {
        panic!("{error}\nthese tests need Vulkan: apt-get install mesa-vulkan-drivers")
    })
}

/// Every ray tests every primitive: the reference.
pub const BRUTE_FORCE: Settings = Settings {
    accuracy: Accuracy::Robust,
    bounds: Bounds::None,
    forced: rayproof::effects::EffectSet::NONE,
};

/// Every choice of volumes but brute force.
pub const CHOICES: [Bounds; 10] = [
    Bounds::Scene,
    Bounds::Spheres { levels: 1 },
    Bounds::Spheres { levels: 2 },
    Bounds::Spheres { levels: 4 },
    Bounds::Boxes { levels: 1 },
    Bounds::Boxes { levels: 2 },
    Bounds::Boxes { levels: 4 },
    Bounds::Screen { levels: 1 },
    Bounds::Screen { levels: 3 },
    Bounds::Tree,
];

/// The picture from the GPU.
pub fn on_gpu(scene: &Scene) -> Frame {
    let backend = Backend::Gpu(Box::new(gpu()));
    rayproof::render(scene, &backend, BRUTE_FORCE, &Unwatched)
        .unwrap()
        .frame
}

/// The picture from the CPU.
pub fn on_cpu(scene: &Scene) -> Frame {
    rayproof::render(scene, &Backend::Cpu(None), BRUTE_FORCE, &Unwatched)
        .unwrap()
        .frame
}

/// A scene of `assets/scenes`.
pub fn scene(name: &str) -> Scene {
    Scene::load(format!("assets/scenes/{name}.toml")).unwrap()
}

pub use rayproof::stability::shapes::white_scene;

/// A sphere of radius 1 in front of the camera.
pub fn sphere_ahead() -> Shape {
    Shape {
        geometry: Geometry::Sphere {
            center: DVec3::new(0.0, 0.0, -3.0),
            radius: 1.0,
        },
        transform: Transform::default(),
        material: 0,
        velocity: DVec3::ZERO,
    }
}

/// A scene of one mesh in front of a camera whose middle rays run along the axes.
pub fn mesh_seen_from(mesh: Mesh, eye: DVec3) -> Scene {
    let mut scene = white_scene(vec![Shape {
        geometry: Geometry::Mesh(Arc::new(mesh)),
        transform: Transform::default(),
        material: 0,
        velocity: DVec3::ZERO,
    }])
    .with_size(32, 32);
    scene.camera.eye = eye;
    scene.camera.target = eye - DVec3::Z;
    scene.camera.sampling = PixelSampling::Corner;
    scene
}

/// A built-in mesh in front of the camera.
pub fn mesh_scene(kind: Builtin, detail: u32, size: u32) -> Scene {
    white_scene(vec![Shape {
        geometry: Geometry::Mesh(Arc::new(build(kind, detail))),
        transform: Transform {
            linear: DMat3::IDENTITY,
            translate: DVec3::new(0.0, 0.0, -3.0),
        },
        material: 0,
        velocity: DVec3::ZERO,
    }])
    .with_size(size, size)
}

/// Compares bit for bit.
pub fn compare(left: &Frame, right: &Frame) -> Comparison {
    rayproof::compare_frames(left, right, &Tolerance::default()).unwrap()
}

/// Fails unless two frames agree in every bit of every layer.
pub fn assert_same_bits(left: &Frame, right: &Frame) {
    let comparison = compare(left, right);
    assert_eq!(
        (
            comparison.different_pixels,
            comparison.max_ulp,
            comparison.id_mismatches
        ),
        (0, 0, 0),
        "{comparison:#?}"
    );
}

/// Renders with each choice of volumes and without, on both backends and in both
/// widths, and compares all layers.
pub fn assert_bounds_change_nothing(scene: &Scene, choices: &[Bounds]) {
    let gpu = Backend::Gpu(Box::new(gpu()));
    let cpu = Backend::Cpu(None);
    let on = |backend: &Backend, accuracy, bounds| {
        let settings = Settings {
            accuracy,
            bounds,
            forced: rayproof::effects::EffectSet::NONE,
        };
        rayproof::render(scene, backend, settings, &Unwatched)
            .unwrap()
            .frame
    };
    let reference = on(&cpu, Accuracy::Robust, Bounds::None);
    let double = on(&cpu, Accuracy::Double, Bounds::None);
    for &bounds in choices {
        assert_same_bits(&reference, &on(&cpu, Accuracy::Robust, bounds));
        assert_same_bits(&reference, &on(&gpu, Accuracy::Robust, bounds));
        assert_same_bits(&double, &on(&cpu, Accuracy::Double, bounds));
    }
}

/// Pixels that differ between brute force and the volumes, on the CPU.
pub fn changed<R: Real>(scene: &Scene, bounds: Bounds) -> usize {
    let plain = flatten::<R>(scene);
    let mut bounded = plain.clone();
    bound(&mut bounded, bounds);
    let without_tests = |pixel: Pixel| Pixel { tests: 0, ..pixel };
    let [width, height] = plain.size;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    pixels
        .filter(|&(x, y)| {
            let with = trace_pixel(&bounded, x, y);
            assert_ne!(with.tests, GIVEN_UP);
            without_tests(trace_pixel(&plain, x, y)) != without_tests(with)
        })
        .count()
}

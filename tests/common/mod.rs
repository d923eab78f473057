//! What several tests need.

#![allow(dead_code, reason = "each test uses a part")]

pub mod random;

use std::sync::Arc;

use glam::{DMat3, DVec3};
use rayproof::bounds::Bounds;
use rayproof::gpu::device::Gpu;
use rayproof::render::Settings;
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{Geometry, Material, Shape, Transform};
use rayproof::{Backend, Comparison, Frame, Scene, Tolerance, Unwatched};

/// The best adapter; without one the test fails, for a check that was not made
/// is no check.
pub fn gpu() -> Gpu {
    Gpu::open(None).unwrap_or_else(|error| {
        panic!("{error}\nthese tests need Vulkan: apt-get install mesa-vulkan-drivers")
    })
}

/// Every ray tests every primitive: the reference.
pub const BRUTE_FORCE: Settings = Settings {
    accuracy: rayproof::Accuracy::Robust,
    bounds: Bounds::None,
};

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

/// A built-in mesh in front of the camera.
pub fn mesh_scene(kind: Builtin, detail: u32, size: u32) -> Scene {
    Scene {
        ambient: [1.0; 3],
        materials: vec![Material {
            name: "white".into(),
            albedo: [0.8; 3],
        }],
        shapes: vec![Shape {
            geometry: Geometry::Mesh(Arc::new(build(kind, detail))),
            transform: Transform {
                linear: DMat3::IDENTITY,
                translate: DVec3::new(0.0, 0.0, -3.0),
            },
            material: 0,
        }],
        ..Scene::default()
    }
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

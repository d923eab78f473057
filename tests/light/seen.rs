//! Pictures, and how sure their means are.

use glam::DVec3;
use rayproof::render::Settings;
use rayproof::scene::{Background, Geometry, Material, Shape, Transform};
use rayproof::{Accuracy, Backend, Frame, Scene, Unwatched};

use crate::common::{BRUTE_FORCE, assert_same_bits, gpu};

/// Standard deviations that chance does not reach: in one of a million tries or so.
pub const FAR: f64 = 5.0;

/// Of each rounding of f32, in parts of the number.
pub const ROUNDING: f64 = 1.0 / (1 << 24) as f64;

/// The mean of a picture, and its standard error.
pub struct Mean {
    /// Of each channel.
    pub color: [f64; 3],
    /// Of the luminance.
    pub error: f64,
    /// The picture.
    pub frame: Frame,
}

/// The mean of a picture from the CPU.
pub fn mean_of(scene: &Scene) -> Mean {
    let made = rayproof::render(scene, &Backend::Cpu(None), BRUTE_FORCE, &Unwatched).unwrap();
    let pixels = made.frame.color.len() as f64;
    let mut color = [0.0; 3];
    for pixel in &made.frame.color {
        for (sum, channel) in color.iter_mut().zip(pixel) {
            *sum += f64::from(*channel) / pixels;
        }
    }
    assert_eq!(made.stats.faults, 0);
    // The noise is that of a pixel, in parts of the mean luminance.
    let luminance = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    let noise = made.stats.noise.unwrap_or(0.0);
    Mean {
        color,
        error: noise * luminance / pixels.sqrt(),
        frame: made.frame,
    }
}

/// A narrow look along -z from the origin, in light of 1 from everywhere.
pub fn looking_at(shapes: Vec<Geometry>, material: Material) -> Scene {
    let shape = |geometry| Shape {
        geometry,
        transform: Transform::default(),
        material: 0,
        velocity: DVec3::ZERO,
    };
    let mut scene = Scene {
        background: Background::plain([1.0; 3]),
        materials: vec![material],
        shapes: shapes.into_iter().map(shape).collect(),
        ..Scene::default()
    }
    .with_size(1, 1);
    scene.camera.fov_degrees = 0.001;
    scene
}

/// A background whose colour tells a direction's height: (1 + y) / 2.
pub fn by_height() -> Background {
    Background {
        from: [0.0; 3],
        to: [1.0; 3],
        offset: 0.5,
        slope: 0.5,
    }
}

/// Fails unless both backends give the same bits, by all of these ways.
pub fn assert_backends_agree(scene: &Scene, all: &[Settings]) {
    let graphics = Backend::Gpu(Box::new(gpu()));
    for settings in all {
        let [here, there] = [&Backend::Cpu(None), &graphics]
            .map(|backend| rayproof::render(scene, backend, *settings, &Unwatched).unwrap());
        assert_same_bits(&there.frame, &here.frame);
    }
}

/// The same by brute force and through a tree: with one sample and with some, with direct
/// light alone and with bounces.
pub fn assert_paths_agree(scene: &Scene) {
    for (samples, bounces) in [(1, 0), (4, 0), (4, 3)] {
        let mut scene = scene.clone();
        scene.integrator.samples = samples;
        scene.integrator.bounces = bounces;
        assert_backends_agree(&scene, &[BRUTE_FORCE, Settings::from(Accuracy::Robust)]);
    }
}

//! A lens in place of the pinhole.

use glam::DVec3;
use rayproof::scene::{Geometry, Material, Shape, Transform};
use rayproof::{Accuracy, Backend, Frame, Scene, Unwatched};

use crate::common::{assert_same_bits, gpu, scene, white_scene};

/// Pixels of the picture's side, and in a length of 1 at distance 1.
const SIDE: u32 = 64;
const UNIT: f64 = 32.0;

const SAMPLES: u32 = 256;

fn on(backend: &Backend, scene: &Scene) -> Frame {
    rayproof::render(scene, backend, Accuracy::Robust, &Unwatched)
        .unwrap()
        .frame
}

/// A disk that shines, straight ahead.
fn bright_disk(distance: f64, radius: f64, aperture: f64, focus: f64) -> Scene {
    let shape = Shape {
        geometry: Geometry::Disk {
            center: DVec3::new(0.0, 0.0, -distance),
            normal: DVec3::Z,
            radius,
        },
        transform: Transform::default(),
        material: 0,
        velocity: DVec3::ZERO,
    };
    let mut scene = white_scene(vec![shape]).with_size(SIDE, SIDE);
    scene.ambient = [0.0; 3];
    scene.materials = vec![Material {
        albedo: [0.0; 3],
        emission: [1.0; 3],
        ..Material::default()
    }];
    scene.camera.fov_degrees = 90.0;
    scene.camera.aperture = aperture;
    scene.camera.focus = Some(focus);
    scene.integrator.samples = SAMPLES;
    scene
}

/// How the light lies around the middle, in pixels: all of it, the mean square of its distance
/// from there, and the distance of the farthest pixel that has any.
fn spread(frame: &Frame) -> [f64; 3] {
    let middle = f64::from(SIDE) / 2.0 - 0.5;
    let mut sums = [0.0; 3];
    for (index, color) in frame.color.iter().enumerate() {
        let x = (index % SIDE as usize) as f64 - middle;
        let y = (index / SIDE as usize) as f64 - middle;
        let light = f64::from(color[0]);
        sums[0] += light;
        sums[1] += light * (x * x + y * y);
        if light > 0.0 {
            sums[2] = sums[2].max(x.hypot(y));
        }
    }
    [sums[0], sums[1] / sums[0], sums[2]]
}

/// Whether the light lies as that of a disk of radius `seen`, in pixels, each point of which is
/// blurred to a disk of radius `blur`.
///
/// The mean square of the distance from the middle is half the square of each radius, and 1/6
/// for the pixels' own size (Sheppard). Of K samples that meet the disk, it is off by
/// root((mean fourth power less squared mean square) / K), less than `blur`^2 + `seen`^2 over
/// root(12 K); five of these are left. No light lies farther out than both radii and half a
/// pixel's diagonal.
fn is_blurred_to(frame: &Frame, blur: f64, seen: f64) -> bool {
    let [light, square, farthest] = spread(frame);
    let hits = light * f64::from(SAMPLES);
    let expected = (blur * blur + seen * seen) / 2.0 + 1.0 / 6.0;
    let tolerance = 5.0 * (blur * blur + seen * seen) / (12.0 * hits).sqrt();
    // As much light as of the pinhole: a sample meets it or not.
    let area = std::f64::consts::PI * seen * seen;
    let noise = 5.0 * (area / f64::from(SAMPLES)).sqrt();
    (light - area).abs() <= noise
        && (square - expected).abs() <= tolerance
        && farthest <= blur + seen + 0.5_f64.sqrt()
}

/// A point at distance z is a disk of the diameter A |1/f - 1/z|, at distance 1, of a lens of
/// the diameter A in focus at f.
#[test]
fn the_circle_of_confusion_is_as_large_as_the_lens_says() {
    let (aperture, radius) = (0.5, 1.0 / 24.0);
    for (distance, focus) in [(1.0, 4.0), (2.0, 0.7), (2.0, 1e6)] {
        let seen: f64 = radius;
        let frame = on(
            &Backend::Cpu(None),
            &bright_disk(distance, seen * distance, aperture, focus),
        );
        let blur = aperture / 2.0 * (1.0 / focus - 1.0 / distance).abs();
        let [blur, seen] = [blur * UNIT, seen * UNIT];
        assert!(
            is_blurred_to(&frame, blur, seen),
            "{distance}, {focus}: {blur}, {seen}: {:?}",
            spread(&frame)
        );
        // The control: a diameter that is a fifth larger or smaller.
        for factor in [0.8, 1.2] {
            assert!(!is_blurred_to(&frame, blur * factor, seen), "{factor}");
        }
    }
}

/// What is in focus is as sharp as a pinhole shows it: each sample meets the same place but
/// for roundings.
#[test]
fn what_is_in_focus_is_sharp() {
    let distance = 3.0;
    let pinhole = bright_disk(distance, 1.0, 0.0, distance);
    let mut lens = bright_disk(distance, 1.0, 0.5, distance);
    let sharp = on(&Backend::Cpu(None), &pinhole);
    let in_focus = on(&Backend::Cpu(None), &lens);
    assert_eq!(sharp.color, in_focus.color);
    // Where the camera looks is in focus, if nothing else is said.
    lens.camera.focus = None;
    lens.camera.target = DVec3::Z * -distance;
    assert_eq!(sharp.color, on(&Backend::Cpu(None), &lens).color);
    lens.camera.focus = Some(distance * 1.1);
    let control = on(&Backend::Cpu(None), &lens);
    assert_ne!(sharp.color, control.color, "the control");
}

#[test]
fn bits_are_the_same_on_both_sides() {
    let mut scene = scene("shapes").with_size(64, 48);
    scene.camera.aperture = 0.4;
    scene.integrator.samples = 3;
    let gpu = Backend::Gpu(Box::new(gpu()));
    let frame = on(&Backend::Cpu(None), &scene);
    assert_same_bits(&frame, &on(&gpu, &scene));
    scene.camera.focus = Some(4.0);
    let control = on(&Backend::Cpu(None), &scene);
    assert!(!control.has_bits_of(&frame), "the control");
}

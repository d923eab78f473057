//! A scene of any size looks the same: a power of two as its scale changes no
//! bit of what has no length.

mod common;

use common::{on_cpu, scene};
use rayproof::scene::Light;
use rayproof::{Frame, Scene};

/// The scene with every length times 2^`exponent`.
fn scaled(scene: &Scene, exponent: i32) -> Scene {
    let factor = 2f64.powi(exponent);
    let mut scene = scene.clone();
    scene.camera.eye *= factor;
    scene.camera.target *= factor;
    for light in &mut scene.lights {
        if let Light::Point { position, .. } = light {
            *position *= factor;
        }
    }
    for shape in &mut scene.shapes {
        shape.transform.linear *= factor;
        shape.transform.translate *= factor;
    }
    scene
}

/// Pixels that show another primitive or another normal.
fn different(left: &Frame, right: &Frame) -> usize {
    let bits = |normal: [f32; 3]| normal.map(f32::to_bits);
    (0..left.pixels())
        .filter(|&at| {
            left.id[at] != right.id[at] || bits(left.normal[at]) != bits(right.normal[at])
        })
        .count()
}

/// From 1e-13 to 1e14: near the smallest size and the largest magnitude that a
/// scene may have.
#[test]
fn ids_and_normals_do_not_depend_on_the_scale() {
    for name in ["shapes", "seed-models", "seed-spheres"] {
        let scene = scene(name).with_size(120, 120);
        let here = on_cpu(&scene);
        for exponent in [-43, -30, -10, 1, 10, 30, 44] {
            let there = on_cpu(&scaled(&scene, exponent));
            assert_eq!(different(&here, &there), 0, "{name} times 2^{exponent}");
        }
    }
}

/// The control: another factor than a power of two rounds.
#[test]
fn a_factor_that_rounds_is_noticed() {
    let scene = scene("shapes").with_size(120, 120);
    let mut there = scene.clone();
    for shape in &mut there.shapes {
        shape.transform.linear *= 1.0 + 1e-6;
    }
    assert!(different(&on_cpu(&scene), &on_cpu(&there)) > 0);
}

//! A scene far from the origin loses nothing.

mod common;

use common::{assert_same_bits, compare, on_cpu, on_gpu, scene};
use glam::DVec3;
use rayproof::scene::{Geometry, Light, Transfer};
use rayproof::{Frame, Layer, Scene};

/// The scene with everything in it moved.
fn moved(scene: &Scene, by: DVec3) -> Scene {
    let mut moved = scene.clone();
    moved.camera.eye += by;
    moved.camera.target += by;
    for light in &mut moved.lights {
        if let Light::Point { position, .. } = light {
            *position += by;
        }
    }
    for shape in &mut moved.shapes {
        shape.transform.translate += by;
    }
    moved
}

/// Coordinates as multiples of 2^-10, so that they can be moved by whole numbers
/// without rounding.
fn dyadic(scene: &Scene) -> Scene {
    let round = |v: DVec3| (v * 1024.0).round() / 1024.0;
    let mut scene = scene.clone();
    scene.camera.eye = round(scene.camera.eye);
    scene.camera.target = round(scene.camera.target);
    for light in &mut scene.lights {
        if let Light::Point { position, .. } = light {
            *position = round(*position);
        }
    }
    for shape in &mut scene.shapes {
        shape.transform.translate = round(shape.transform.translate);
    }
    scene
}

fn scenes() -> [Scene; 3] {
    [
        scene("seed-spheres").with_size(250, 250),
        scene("shapes").with_size(250, 250),
        scene("seed-models").with_size(100, 100),
    ]
    .map(|scene| dyadic(&scene))
}

#[test]
fn an_exact_offset_changes_no_bit() {
    let by = DVec3::new(1e6, -(f64::from(1 << 20)), 123_456.0);
    for scene in scenes() {
        let here = on_cpu(&scene);
        let there = moved(&scene, by);
        assert_same_bits(&here, &on_cpu(&there));
        assert_same_bits(&here, &on_gpu(&there));
    }
}

/// Pixels of a PNG that differ by more than one step of a channel, which is what a
/// value on the border between two steps may move by.
fn visibly_different(left: &Frame, right: &Frame) -> usize {
    let bytes = |frame: &Frame| frame.to_rgb8(Layer::Color, Transfer::Srgb);
    bytes(left)
        .iter()
        .zip(bytes(right))
        .filter(|(a, b)| a.abs_diff(*b) > 1)
        .count()
}

/// An offset that is not exact moves each coordinate by at most half an ulp of
/// 1e6 in f64, 6e-11 units. An f32 coordinate of about 5 has an ulp of 5e-7, so it
/// moves by one ulp where it lies within 6e-11 of a rounding boundary, one time
/// in 4000. A silhouette thus moves by some 1e-7 units where a pixel is 1e-2 wide:
/// of the few thousand pixels on silhouettes, none is expected to change sides.
#[test]
fn an_inexact_offset_leaves_no_artefacts() {
    let by = DVec3::new(1e6 + 0.1, 1e6 + 0.7, -1e6 / 3.0);
    for scene in scenes() {
        let here = on_cpu(&scene);
        let there = on_gpu(&moved(&scene, by));
        assert_eq!(compare(&here, &there).id_mismatches, 0);
        assert_eq!(visibly_different(&here, &there), 0);
    }
}

/// The control: rounding to f32 before the camera is subtracted, as is often
/// done, is seen at once.
#[test]
fn rounding_before_subtracting_is_noticed() {
    let by = DVec3::splat(1e6 + 0.1);
    let scene = dyadic(&scene("shapes").with_size(250, 250));
    let mut there = moved(&scene, by);
    let rounded = |v: DVec3| v.as_vec3().as_dvec3();
    there.camera.eye = rounded(there.camera.eye);
    there.camera.target = rounded(there.camera.target);
    for shape in &mut there.shapes {
        shape.transform.translate = rounded(shape.transform.translate);
        if let Geometry::Sphere { center, .. } = &mut shape.geometry {
            *center = rounded(*center);
        }
    }
    assert!(visibly_different(&on_cpu(&scene), &on_cpu(&there)) > 100);
}

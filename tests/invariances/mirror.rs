//! A scene in a mirror is the picture in a mirror.
//!
//! Bit for bit: the camera's axis to the right changes its sign in place of x, screen
//! coordinates of opposite pixel centres are opposite numbers, and each formula of a shape or
//! a box is made of sums and products that a change of signs does not round otherwise.

use glam::DVec3;
use rayproof::bounds::Bounds;
use rayproof::scene::PixelSampling;
use rayproof::{Accuracy, Backend, Frame, Scene};

use super::{TIERS, assert_holds, different, generated, mapped, picture};

fn mirrored(scene: &Scene) -> Scene {
    mapped(scene, DVec3::new(-1.0, 1.0, 1.0), DVec3::ZERO)
}

fn reversed<T>(layer: &mut [T], width: u32) {
    layer.chunks_mut(width as usize).for_each(<[T]>::reverse);
}

fn mirror_image(frame: &Frame) -> Frame {
    let mut frame = frame.clone();
    let width = frame.width;
    reversed(&mut frame.color, width);
    reversed(&mut frame.depth, width);
    reversed(&mut frame.normal, width);
    reversed(&mut frame.position, width);
    reversed(&mut frame.id, width);
    for vector in frame.normal.iter_mut().chain(&mut frame.position) {
        vector[0] = -vector[0];
    }
    frame
}

#[test]
fn a_mirrored_scene_is_a_mirrored_picture() {
    assert_holds("mirror", mirrored, mirror_image, &TIERS, generated);
}

/// The controls: rays through the corners of pixels are not opposite, nor is a scene to itself.
#[test]
fn what_is_not_symmetric_is_noticed() {
    let mut scene = generated(0);
    let differing = |scene: &Scene, other: &Scene| {
        let [here, there] = [scene, other]
            .map(|scene| picture(scene, &Backend::Cpu(None), Accuracy::Robust, Bounds::Tree));
        different(&mirror_image(&here), &there)
    };
    assert!(differing(&scene, &scene) > 100);
    scene.camera.sampling = PixelSampling::Corner;
    assert!(differing(&scene, &mirrored(&scene)) > 100);
}

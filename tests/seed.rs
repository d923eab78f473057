//! The 2017 report's first test: 72 spheres, a million pixels.

mod common;

use common::{on_cpu, scene};
use rayproof::layout::NO_HIT;
use rayproof::{Accuracy, Backend, Frame, Unwatched};

fn sphere_pixels(frame: &Frame) -> usize {
    frame.id.iter().filter(|&&id| id != NO_HIT).count()
}

fn in_f64(scene: &rayproof::Scene) -> Frame {
    rayproof::render(scene, &Backend::Cpu(None), Accuracy::Double, &Unwatched)
        .unwrap()
        .frame
}

#[test]
fn f64_shows_the_reports_count_of_pixels() {
    assert_eq!(sphere_pixels(&in_f64(&scene("seed-spheres"))), 5540);
}

#[test]
fn f32_differs_at_grazing_rays_only() {
    let scene = scene("seed-spheres");
    let (f32_frame, f64_frame) = (on_cpu(&scene), in_f64(&scene));
    let different: Vec<usize> = (0..f64_frame.pixels())
        .filter(|&pixel| f32_frame.id[pixel] != f64_frame.id[pixel])
        .collect();
    let count = sphere_pixels(&f32_frame);
    println!("f32: {count} pixels; differing: {different:?}");
    assert!(count.abs_diff(5540) <= 4 && different.len() <= 4);
}

/// The control: a pixel's middle is not its corner.
#[test]
fn sampling_at_the_center_gives_another_count() {
    let mut scene = scene("seed-spheres");
    scene.camera.sampling = rayproof::scene::PixelSampling::Center;
    assert_ne!(sphere_pixels(&in_f64(&scene)), 5540);
}

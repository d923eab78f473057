//! Scenes that nobody thought of: GPU and CPU agree on them, bit for bit.

mod common;

use common::gpu;
use common::random::random_scene;
use rayproof::Unwatched;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::gpu::device::Gpu;
use rayproof::gpu::render::{Portions, render};
use rayproof::kernel::trace::trace_pixel;
use rayproof::layout::Pixel;

fn gpu_pixels(gpu: &Gpu, flat: &Flat<f32>) -> Vec<Pixel> {
    let mut pixels = Vec::new();
    render(
        gpu,
        flat,
        Portions::default(),
        &Unwatched,
        &mut |_, rows| {
            pixels.extend_from_slice(rows);
        },
    )
    .unwrap();
    pixels
}

/// Pixels with any bit different.
fn different(flat: &Flat<f32>, pixels: &[Pixel]) -> usize {
    (0..)
        .zip(pixels)
        .filter(|(index, pixel)| {
            let cpu = trace_pixel(flat, index % flat.size[0], index / flat.size[0]);
            bytemuck::bytes_of(&cpu) != bytemuck::bytes_of(*pixel)
        })
        .count()
}

#[test]
fn agree_at_every_scale() {
    let gpu = gpu();
    let mut hits = 0;
    for (seed, exponent) in (0..).zip([-12, -9, -6, -3, -1, 0, 0, 0, 0, 1, 2, 4, 6, 9, 12]) {
        let scene = random_scene(seed, 10f64.powi(exponent));
        scene.validate().unwrap();
        let flat = flatten::<f32>(&scene);
        let pixels = gpu_pixels(&gpu, &flat);
        hits += pixels.iter().filter(|pixel| pixel.id != u32::MAX).count();
        assert_eq!(
            different(&flat, &pixels),
            0,
            "seed {seed}, scale 1e{exponent}"
        );
    }
    assert!(hits > 10_000, "only {hits} hits: the scenes test nothing");
}

/// The control: one bit of one pixel.
#[test]
fn one_bit_is_noticed() {
    let flat = flatten::<f32>(&random_scene(3, 1.0));
    let mut pixels = gpu_pixels(&gpu(), &flat);
    assert_eq!(different(&flat, &pixels), 0);
    pixels[1000].color[1] = f32::from_bits(pixels[1000].color[1].to_bits() ^ 1);
    assert_eq!(different(&flat, &pixels), 1);
}

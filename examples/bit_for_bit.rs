//! Renders a scene on GPU and CPU and compares the two pictures bit for bit;
//! then moves one sphere by a millionth and shows that the comparison notices.
//!
//! ```console
//! $ cargo run --example bit_for_bit -- assets/scenes/shapes.toml
//! ```

use rayproof::gpu::device::Gpu;
use rayproof::scene::Geometry;
use rayproof::{Accuracy, Backend, Comparison, Scene, Tolerance, Unwatched};
use rayproof::{compare_frames, render};

fn main() -> miette::Result<()> {
    let file = std::env::args().nth(1);
    let file = file.as_deref().unwrap_or("assets/scenes/shapes.toml");
    let scene = Scene::load(file)?.with_size(300, 300);

    // `Backend::auto` would be the CPU where there is no adapter: nothing to compare.
    let gpu = Backend::Gpu(Box::new(Gpu::open(None)?));
    let cpu = Backend::Cpu(None);
    println!(
        "as it is:      {}",
        said(&compare(&scene, &gpu, &scene, &cpu)?)
    );

    let moved = with_first_sphere_moved(&scene, 1e-6);
    println!(
        "moved by 1e-6: {}",
        said(&compare(&scene, &gpu, &moved, &cpu)?)
    );
    Ok(())
}

fn compare(
    left: &Scene,
    left_backend: &Backend,
    right: &Scene,
    right_backend: &Backend,
) -> rayproof::Result<Comparison> {
    let left = render(left, left_backend, Accuracy::Robust, &Unwatched)?;
    let right = render(right, right_backend, Accuracy::Robust, &Unwatched)?;
    compare_frames(&left.frame, &right.frame, &Tolerance::default())
}

fn said(comparison: &Comparison) -> String {
    format!(
        "{} of {} pixels differ, by up to {} ulp",
        comparison.different_pixels, comparison.pixels, comparison.max_ulp
    )
}

/// The scene with its first sphere `distance` further to the right.
fn with_first_sphere_moved(scene: &Scene, distance: f64) -> Scene {
    let mut scene = scene.clone();
    let is_sphere = |geometry: &Geometry| matches!(geometry, Geometry::Sphere { .. });
    let sphere = scene
        .shapes
        .iter_mut()
        .find(|shape| is_sphere(&shape.geometry));
    match sphere {
        Some(shape) => shape.transform.translate.x += distance,
        None => println!("the scene has no sphere to move"),
    }
    scene
}

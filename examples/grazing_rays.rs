//! Renders `seed-spheres.toml` in f64 and in f32, counts the pixels that show a
//! sphere, and lists the rays that pass nearest to the rim of one: the first to
//! fall on the other side when arithmetic rounds.
//!
//! ```console
//! $ cargo run --example grazing_rays
//! ```

use rayproof::flatten::flatten;
use rayproof::frame::NO_HIT;
use rayproof::kernel::camera::{Ray, camera_ray};
use rayproof::kernel::vector::{Vec3, dot_product, vector_length};
use rayproof::layout::Sphere;
use rayproof::{Accuracy, Backend, Frame, Scene, Unwatched, render};

/// One rounding to f32 moves a number by up to so much of itself.
const ROUNDING: f64 = f32::EPSILON as f64 / 2.0;

/// Rays that pass further from every rim, in roundings, are not listed.
const LISTED: f64 = 20.0;

fn main() -> miette::Result<()> {
    let scene = Scene::load("assets/scenes/seed-spheres.toml")?;
    let cpu = Backend::Cpu(None);
    let double = render(&scene, &cpu, Accuracy::Double, &Unwatched)?.frame;
    let single = render(&scene, &cpu, Accuracy::Robust, &Unwatched)?.frame;
    let differ = double.id.iter().zip(&single.id).filter(|(d, s)| d != s);
    println!("pixels that show a sphere in f64: {}", hits(&double));
    println!("pixels that show a sphere in f32: {}", hits(&single));
    println!("pixels that show another thing:   {}", differ.count());

    let flat = flatten::<f64>(&scene);
    let mut rays: Vec<(f64, usize, usize)> = Vec::new();
    for pixel in 0..double.pixels() {
        let (x, y) = place(&double, pixel);
        let ray = camera_ray(&flat.camera, flat.size, x, y);
        for (id, sphere) in flat.spheres.iter().enumerate() {
            let distance = roundings_to_rim(ray, sphere);
            if distance.abs() < LISTED {
                rays.push((distance, pixel, id));
            }
        }
    }
    rays.sort_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
    println!("    x    y  sphere  roundings outside its rim  shown in f64  in f32");
    for (distance, pixel, id) in rays {
        let (x, y) = place(&double, pixel);
        let [in_double, in_single] = [&double, &single].map(|frame| name(frame.id[pixel]));
        println!("{x:5}{y:5}{id:8}{distance:27.2}{in_double:>14}{in_single:>8}");
    }
    Ok(())
}

fn hits(frame: &Frame) -> usize {
    frame.id.iter().filter(|&&id| id != NO_HIT).count()
}

fn place(frame: &Frame, pixel: usize) -> (u32, u32) {
    (pixel as u32 % frame.width, pixel as u32 / frame.width)
}

fn name(id: u32) -> String {
    match id {
        NO_HIT => "none".into(),
        id => id.to_string(),
    }
}

/// How far outside the sphere's rim the ray passes, in roundings of its distance
/// from the camera.
fn roundings_to_rim(ray: Ray<f64>, sphere: &Sphere<f64>) -> f64 {
    let center = Vec3::from(sphere.center);
    let along = dot_product(center, ray.direction) / dot_product(ray.direction, ray.direction);
    let passes_at = vector_length(ray.direction * along - center);
    (passes_at - sphere.radius) / (ROUNDING * vector_length(center))
}

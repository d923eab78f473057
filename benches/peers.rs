//! The closest hits of a picture's rays: this crate beside its peers, in one run.
//!
//! `cargo bench --bench peers -- [--runs N] [SCENE...]`; without scenes, two knots.
//! The scenes hold triangles only. Each peer gets the same rays, one by one, and makes
//! of a ray what it needs within the time that is measured.

mod peers {
    pub mod bvh;
    pub mod obvhs;
    pub mod rayproof;
}

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

use rayon::prelude::*;
use rayproof::Scene;
use rayproof::bounds::{Bounds, bound};
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::kernel::camera::{Ray, camera_ray};
use rayproof::kernel::triangles::triangle_of;
use rayproof::layout::Triangle;
use rayproof::measure::{Plan, Spread, interleave};
use rayproof::scene::mesh::{self, Builtin};
use rayproof::scene::{Geometry, Material, Shape, Transform};

/// t and the number of the triangle, or infinity.
pub type Found = (f32, u32);

/// Finds the closest hits of some rays.
pub type Trace<'a> = Box<dyn Fn(&[Ray<f32>], &mut [Found]) + Sync + 'a>;

/// Rays that a thread takes at once.
const SHARE: usize = 500;

fn main() -> Result<(), Box<dyn Error>> {
    let mut runs = 9;
    let mut scenes = Vec::new();
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            // What cargo itself adds.
            "--bench" => {}
            "--runs" => runs = arguments.next().ok_or("--runs needs a number")?.parse()?,
            file => scenes.push((file.to_string(), Scene::load(file)?)),
        }
    }
    if scenes.is_empty() {
        for detail in [69_000, 871_000] {
            scenes.push((format!("knot of {detail}"), knot(detail)));
        }
    }
    for (name, scene) in scenes {
        compare(&name, &scene, runs)?;
    }
    Ok(())
}

/// A knot that fills the picture.
fn knot(detail: u32) -> Scene {
    let mut scene = Scene {
        materials: vec![Material {
            name: "white".into(),
            albedo: [0.8; 3],
        }],
        shapes: vec![Shape {
            geometry: Geometry::Mesh(Arc::new(mesh::build(Builtin::Knot, detail))),
            transform: Transform::default(),
            material: 0,
        }],
        ..Scene::default()
    }
    .with_size(1000, 1000);
    scene.camera.eye.z = 4.2;
    scene
}

fn compare(name: &str, scene: &Scene, runs: u32) -> Result<(), Box<dyn Error>> {
    let plain = flatten::<f32>(scene);
    let triangles: Vec<_> = plain
        .triangles
        .iter()
        .map(|&corners| triangle_of(&plain, corners))
        .collect();
    let rays = rays_of(&plain);
    println!("\n{name}: {} triangles, {} rays", triangles.len(), rays.len());
    let mut bounded = plain.clone();
    timed("rayproof's tree", || bound(&mut bounded, Bounds::Tree));
    let contenders = contenders(&bounded, &triangles);
    println!("{:>28} {:>8} {:>22} {:>7} {:>6}", "Mrays/s", "threads", "min to max", "hits", "ratio");
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
        let plan = Plan {
            warm_ups: 1,
            runs,
            budget: f64::INFINITY,
        };
        let mut found = vec![vec![(0.0, 0); rays.len()]; contenders.len()];
        let times = interleave(&plan, contenders.len(), &mut |turn| {
            let (_, trace) = &contenders[turn.job];
            let started = Instant::now();
            pool.install(|| {
                rays.par_chunks(SHARE)
                    .zip(found[turn.job].par_chunks_mut(SHARE))
                    .for_each(|(rays, found)| trace(rays, found));
            });
            Ok(started.elapsed().as_secs_f64())
        })?;
        let best_peer = (2..contenders.len())
            .map(|peer| Spread::of(&times[peer].seconds).median)
            .fold(f64::INFINITY, f64::min);
        for (((label, _), times), found) in contenders.iter().zip(&times).zip(&found) {
            let spread = Spread::of(&times.seconds);
            let rate = |seconds: f64| rays.len() as f64 / seconds / 1e6;
            let hits = found.iter().filter(|(t, _)| t.is_finite()).count();
            println!(
                "{label:>20} {:>7.2} {threads:>8} {:>11.2} to {:>7.2} {hits:>7} {:>6.2}",
                rate(spread.median),
                rate(spread.max),
                rate(spread.min),
                best_peer / spread.median,
            );
        }
        for (peer, (label, _)) in contenders.iter().enumerate().skip(1) {
            let different = disagreements(&found[0], &found[peer]);
            // Edges: they are not watertight, or pick another of two at the same t.
            assert!(
                different * 1000 < rays.len(),
                "{label} finds other hits: {different}"
            );
        }
    }
    Ok(())
}

fn contenders<'a>(flat: &'a Flat<f32>, triangles: &'a [Triangle<f32>]) -> Vec<(&'static str, Trace<'a>)> {
    vec![
        timed("rayproof", || peers::rayproof::wide(flat)),
        timed("rayproof, the twin", || peers::rayproof::twin(flat)),
        timed("obvhs bvh2", || peers::obvhs::bvh2(triangles)),
        timed("obvhs cwbvh", || peers::obvhs::cwbvh(triangles)),
        timed("bvh", || peers::bvh::bvh(triangles)),
    ]
}

/// Says how long it takes to build something.
fn timed<T>(label: &'static str, build: impl FnOnce() -> T) -> (&'static str, T) {
    let started = Instant::now();
    let built = build();
    println!("{label:>20} built in {:>7.1} ms", started.elapsed().as_secs_f64() * 1e3);
    (label, built)
}

fn rays_of(flat: &Flat<f32>) -> Vec<Ray<f32>> {
    let [width, height] = flat.size;
    (0..height)
        .flat_map(|y| (0..width).map(move |x| camera_ray(&flat.camera, flat.size, x, y)))
        .collect()
}

fn disagreements(ours: &[Found], theirs: &[Found]) -> usize {
    let same = |a: f32, b: f32| a == b || (a - b).abs() < 1e-3 * a.abs();
    ours.iter()
        .zip(theirs)
        .filter(|(a, b)| !same(a.0, b.0))
        .count()
}

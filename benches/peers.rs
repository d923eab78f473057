//! The closest hits of a picture's rays: this crate beside its peers, in one run.
//!
//! `cargo bench --bench peers -- [--runs N] [SCENE...]`; without scenes, two knots.
//! The scenes hold triangles only. Each peer gets the same rays, one by one, and makes
//! of a ray what it needs within the time that is measured.

mod peers {
    pub mod bvh;
    pub mod obvhs;
    pub mod plain;
    pub mod rayproof;
}

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

use rayon::ThreadPool;
use rayon::prelude::*;
use rayproof::Scene;
use rayproof::bounds::{Bounds, bound};
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::gpu::device::Gpu;
use rayproof::kernel::camera::{Ray, camera_ray};
use rayproof::kernel::triangles::triangle_of;
use rayproof::layout::Triangle;
use rayproof::measure::{Plan, Spread, Times, interleave};
use rayproof::scene::mesh::{self, Builtin};
use rayproof::scene::{Geometry, Material, Shape, Transform};

/// t and the number of the triangle, or infinity.
pub type Found = (f32, u32);

/// Finds the closest hits of some rays.
pub type Trace<'a> = Box<dyn Fn(&[Ray<f32>], &mut [Found]) + Sync + 'a>;

/// Finds the closest hits of a picture on a device, and gives the seconds of the search.
pub type Search<'a> = Box<dyn FnMut(&mut [Found]) -> Outcome<f64> + 'a>;

/// Whatever may go wrong.
pub type Outcome<T> = Result<T, Box<dyn Error>>;

/// Rays that a thread takes at once.
const SHARE: usize = 500;

fn main() -> Outcome<()> {
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
            ..Material::default()
        }],
        shapes: vec![Shape {
            geometry: Geometry::Mesh(Arc::new(mesh::build(Builtin::Knot, detail))),
            transform: Transform::default(),
            material: 0,
            velocity: glam::DVec3::ZERO,
        }],
        ..Scene::default()
    }
    .with_size(1000, 1000);
    scene.camera.eye.z = 4.2;
    scene
}

fn compare(name: &str, scene: &Scene, runs: u32) -> Outcome<()> {
    let plain = flatten::<f32>(scene);
    let triangles: Vec<_> = plain
        .triangles
        .iter()
        .map(|&corners| triangle_of(&plain, corners))
        .collect();
    let rays = rays_of(&plain);
    println!(
        "\n{name}: {} triangles, {} rays",
        triangles.len(),
        rays.len()
    );
    let mut bounded = plain.clone();
    timed("rayproof's tree", || bound(&mut bounded, Bounds::Tree));
    let gpu = Gpu::open(None)?;
    let mut contenders = contenders(&gpu, &bounded, &triangles)?;
    let cores = std::thread::available_parallelism()?.get();
    for threads in [1, cores] {
        println!(
            "\n{:>20} {:>8} {:>8} {:>8} {:>8} {:>8}",
            "", "threads", "Mrays/s", "least", "most", "ratio"
        );
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()?;
        let mut found = vec![vec![(0.0, 0); rays.len()]; contenders.len()];
        let plan = Plan {
            warm_ups: 1,
            runs,
            budget: f64::INFINITY,
        };
        // A software driver takes all cores.
        let racing: Vec<usize> = (0..contenders.len())
            .filter(|&index| threads == cores || !contenders[index].needs_all_cores())
            .collect();
        let times = interleave(&plan, racing.len(), &mut |turn| {
            let index = racing[turn.job];
            contenders[index]
                .run(&pool, &rays, &mut found[index])
                .map_err(|error| rayproof::Error::DeviceLost(error.to_string()))
        })?;
        let median = |times: &Times| Spread::of(&times.seconds).median;
        let best_peer = racing
            .iter()
            .zip(&times)
            .filter(|(index, _)| contenders[**index].label.starts_with("obvhs"))
            .map(|(_, times)| median(times))
            .fold(f64::INFINITY, f64::min);
        for (&index, times) in racing.iter().zip(&times) {
            let spread = Spread::of(&times.seconds);
            let rate = |seconds: f64| rays.len() as f64 / seconds / 1e6;
            println!(
                "{:>20} {threads:>8} {:>8.2} {:>8.2} {:>8.2} {:>8.2}",
                contenders[index].label,
                rate(spread.median),
                rate(spread.max),
                rate(spread.min),
                best_peer / spread.median,
            );
        }
        for &peer in &racing[1..] {
            let label = contenders[peer].label;
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

fn contenders<'a>(
    gpu: &'a Gpu,
    flat: &'a Flat<f32>,
    triangles: &'a [Triangle<f32>],
) -> Outcome<Vec<Contender<'a>>> {
    let on_cpu = |label, trace: fn(&'a [Triangle<f32>]) -> Trace<'a>| Contender {
        label,
        tracer: Tracer::Threads(timed(label, || trace(triangles))),
    };
    Ok(vec![
        Contender {
            label: "rayproof",
            tracer: Tracer::Threads(timed("rayproof", || peers::rayproof::wide(flat))),
        },
        Contender {
            label: "rayproof, the twin",
            tracer: Tracer::Threads(peers::rayproof::twin(flat)),
        },
        on_cpu("obvhs bvh2", peers::obvhs::bvh2),
        on_cpu("obvhs cwbvh", peers::obvhs::cwbvh),
        on_cpu("bvh", peers::bvh::bvh),
        Contender {
            label: "rayproof, GPU",
            tracer: Tracer::Device(peers::rayproof::on_gpu(gpu, flat)?),
        },
        Contender {
            label: "plain BVH2, GPU",
            tracer: Tracer::Device(peers::plain::on_gpu(flat)?),
        },
    ])
}

/// Who finds the closest hits of all rays.
struct Contender<'a> {
    label: &'static str,
    tracer: Tracer<'a>,
}

enum Tracer<'a> {
    Threads(Trace<'a>),
    Device(Search<'a>),
}

impl Contender<'_> {
    fn needs_all_cores(&self) -> bool {
        matches!(self.tracer, Tracer::Device(_))
    }

    /// Gives the seconds that the search took.
    fn run(&mut self, pool: &ThreadPool, rays: &[Ray<f32>], found: &mut [Found]) -> Outcome<f64> {
        match &mut self.tracer {
            Tracer::Device(search) => search(found),
            Tracer::Threads(trace) => {
                let started = Instant::now();
                pool.install(|| {
                    rays.par_chunks(SHARE)
                        .zip(found.par_chunks_mut(SHARE))
                        .for_each(|(rays, found)| trace(rays, found));
                });
                Ok(started.elapsed().as_secs_f64())
            }
        }
    }
}

/// Says how long it takes to build something.
fn timed<T>(label: &str, build: impl FnOnce() -> T) -> T {
    let started = Instant::now();
    let built = build();
    let ms = started.elapsed().as_secs_f64() * 1e3;
    println!("{label:>20} built in {ms:>7.1} ms");
    built
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

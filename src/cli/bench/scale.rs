//! `rayproof bench --scale`: how times and memory grow with the triangles of a mesh.

use std::sync::Arc;
use std::time::Instant;

use serde::Serialize;

use super::BoundedScene;
use super::case::{Case, Tracer};
use super::flags::BenchArguments;
use crate::cli::Outcome;
use crate::cli::flags::Common;
use crate::cli::progress::Progress;
use crate::cli::report;
use crate::cli::report::columns;
use rayproof::bounds::{self, Bounds};
use rayproof::cpu;
use rayproof::error::Result;
use rayproof::flatten::flatten;
use rayproof::frame::Frame;
use rayproof::gpu::device::Gpu;
use rayproof::measure::{Plan, Spread, growth_exponent, interleave};
use rayproof::scene::mesh::{self, Builtin};
use rayproof::scene::{Geometry, Light, Material, Scene, Shape, Transform};

/// How far the camera is from the knot, which it just sees whole.
const DISTANCE: f64 = 4.2;

/// The result of one call.
#[derive(Debug, Serialize)]
struct Growth {
    mesh: &'static str,
    width: u32,
    height: u32,
    warmup: u32,
    runs: Vec<Measured>,
    exponents: Exponents,
}

/// One size on one backend.
#[derive(Debug, Serialize)]
struct Measured {
    triangles: u32,
    backend: &'static str,
    adapter: Option<String>,
    threads: Option<usize>,
    median_ms: f64,
    min_ms: f64,
    max_ms: f64,
    /// By the device's clock: the passes in which closest hits are found.
    search_ms: Option<f64>,
    build_ms: f64,
    device_bytes: u64,
}

/// With which exponent of the triangles something grows.
#[derive(Debug, Serialize)]
struct Exponents {
    build: f64,
    device_bytes: f64,
    /// Of each backend, in the order of the runs.
    trace: Vec<f64>,
    search: Option<f64>,
}

/// Measures knots of these sizes, one after the other.
pub(super) fn run(sizes: &[u32], arguments: &BenchArguments, common: &Common) -> Result<Outcome> {
    let device = arguments.open_gpu()?;
    let plan = arguments.plan();
    let (width, height) = arguments.knot_size();
    let mut runs: Vec<Measured> = Vec::new();
    let mut backends = 1;
    for &size in sizes {
        let scene = knot(size).with_size(width, height);
        scene.validate()?;
        let measured = measure(&scene, arguments, device.as_ref(), &plan, common)?;
        // Below the coarsest knot, several sizes are the same.
        if runs.last().map(|run| run.triangles) != measured.last().map(|run| run.triangles) {
            backends = measured.len();
            runs.extend(measured);
        }
    }
    let growth = Growth {
        mesh: "knot",
        width,
        height,
        warmup: plan.warm_ups,
        exponents: exponents(&runs, backends),
        runs,
    };
    if common.json {
        report::print(&report::json(&growth))?;
    } else if !common.quiet {
        report::print(&growth.table(&plan))?;
    }
    Ok(Outcome::Done)
}

/// A lit knot that fills the picture.
fn knot(detail: u32) -> Scene {
    let mut scene = Scene {
        materials: vec![Material {
            name: "white".into(),
            albedo: [0.8; 3],
            ..Material::default()
        }],
        lights: vec![Light::Directional {
            direction: glam::DVec3::new(1.0, 2.0, 3.0),
            color: [1.0; 3],
            shadow: false,
        }],
        shapes: vec![Shape {
            geometry: Geometry::Mesh(Arc::new(mesh::build(Builtin::Knot, detail))),
            transform: Transform::default(),
            material: 0,
            velocity: glam::DVec3::ZERO,
        }],
        ..Scene::default()
    };
    scene.camera.eye = glam::DVec3::new(0.0, 0.0, DISTANCE);
    scene.camera.target = glam::DVec3::ZERO;
    scene
}

/// Measures a scene with a tree on each backend.
fn measure(
    scene: &Scene,
    arguments: &BenchArguments,
    device: Option<&Gpu>,
    plan: &Plan,
    common: &Common,
) -> Result<Vec<Measured>> {
    let mut flat = flatten::<f32>(scene);
    let times = interleave(plan, 1, &mut |_| {
        let started = Instant::now();
        bounds::bound(&mut flat, Bounds::Tree);
        Ok(started.elapsed().as_secs_f64())
    })?;
    let bounded = BoundedScene {
        bounds: Bounds::Tree,
        flat,
        build: Spread::of(&times[0].seconds),
    };
    let mut cases = Vec::new();
    for threads in arguments.threads(device) {
        let prepared = cpu::Prepared::new(&bounded.flat, threads)?;
        cases.push(Case::new(&bounded, Tracer::Cpu(prepared)));
    }
    if let Some(device) = device {
        cases.push(Case::new(&bounded, Tracer::on_gpu(device, &bounded)?));
    }
    let triangles = bounded.flat.primitives();
    let mut frame = Frame::new(scene.image.width, scene.image.height)?;
    let times = interleave(plan, cases.len(), &mut |turn| {
        let case = &mut cases[turn.job];
        let label = format!("{triangles} triangles, {}", case.label(turn));
        case.trace(turn, &mut frame, &Progress::new(common, label))
    })?;
    let measured = cases.iter().zip(&times).map(|(case, times)| {
        let trace_ms = Spread::of(&times.seconds).times(1e3);
        Measured {
            triangles,
            backend: case.backend(),
            adapter: case.adapter().map(str::to_string),
            threads: case.threads(),
            median_ms: trace_ms.median,
            min_ms: trace_ms.min,
            max_ms: trace_ms.max,
            search_ms: case.search_ms(),
            build_ms: case.build_ms(),
            device_bytes: bounded.flat.bytes(),
        }
    });
    Ok(measured.collect())
}

/// Of runs that take turns on so many backends, of which the GPU is the last.
fn exponents(runs: &[Measured], backends: usize) -> Exponents {
    let of = |backend: usize, value: &dyn Fn(&Measured) -> Option<f64>| {
        let own = runs.iter().skip(backend).step_by(backends);
        let points: Vec<_> = own
            .filter_map(|run| Some((f64::from(run.triangles), value(run)?)))
            .collect();
        growth_exponent(&points)
    };
    Exponents {
        build: of(0, &|run| Some(run.build_ms)),
        device_bytes: of(0, &|run| Some(run.device_bytes as f64)),
        trace: (0..backends)
            .map(|backend| of(backend, &|run| Some(run.median_ms)))
            .collect(),
        search: Some(of(backends - 1, &|run| run.search_ms)).filter(|search| search.is_finite()),
    }
}

impl Growth {
    /// For people.
    fn table(&self, plan: &Plan) -> String {
        let head = [
            "backend",
            "triangles",
            "median ms",
            "min",
            "max",
            "search ms",
            "build ms",
            "bytes each",
        ];
        let rows = self.runs.iter().map(|run| {
            let threads = run
                .threads
                .map_or(String::new(), |n| format!(", {n} threads"));
            [
                format!("{}{threads}", run.backend),
                run.triangles.to_string(),
                format!("{:.2}", run.median_ms),
                format!("{:.2}", run.min_ms),
                format!("{:.2}", run.max_ms),
                run.search_ms.map_or("-".into(), |ms| format!("{ms:.2}")),
                format!("{:.2}", run.build_ms),
                format!("{:.1}", run.device_bytes as f64 / f64::from(run.triangles)),
            ]
        });
        let adapter = self.runs.iter().find_map(|run| run.adapter.as_deref());
        let exponents = &self.exponents;
        let mut about = vec![("mesh", format!("knot, {} x {}", self.width, self.height))];
        about.extend(adapter.map(|adapter| ("adapter", adapter.to_string())));
        let measured = format!(
            "through a tree; {} + {} runs, one size after the other",
            plan.warm_ups, plan.runs
        );
        about.push(("measured", measured));
        let mut text = report::table(&about) + "\n" + &columns(head, rows);
        if !exponents.build.is_finite() {
            return text + "\none size: no growth to be told\n";
        }
        text += "\ngrowth with the triangles n:\n";
        for (run, exponent) in self.runs.iter().zip(&exponents.trace) {
            text += &format!("  n^{exponent:.3}  a picture on the {}\n", run.backend);
        }
        if let Some(search) = exponents.search {
            text += &format!("  n^{search:.3}  its search, by the device's clock\n");
        }
        text += &format!("  n^{:.3}  building the tree\n", exponents.build);
        text + &format!("  n^{:.3}  bytes on the device\n", exponents.device_bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_are_of_each_backend() {
        let run = |triangles, backend, median_ms, search_ms| Measured {
            triangles,
            backend,
            adapter: None,
            threads: None,
            median_ms,
            min_ms: median_ms,
            max_ms: median_ms,
            search_ms,
            build_ms: f64::from(triangles),
            device_bytes: 7,
        };
        let found = exponents(
            &[
                run(100, "cpu", 1.0, None),
                run(100, "gpu", 4.0, Some(1.0)),
                run(10_000, "cpu", 10.0, None),
                run(10_000, "gpu", 4.0, Some(100.0)),
            ],
            2,
        );
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(
            near(found.trace[0], 0.5) && near(found.trace[1], 0.0),
            "{found:?}"
        );
        assert!(
            near(found.search.unwrap(), 1.0) && near(found.build, 1.0),
            "{found:?}"
        );
        assert!(near(found.device_bytes, 0.0), "{found:?}");
        assert!(exponents(&[run(100, "cpu", 1.0, None)], 1).search.is_none());
    }
}

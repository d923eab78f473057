//! The GPU's picture equals the CPU's, bit for bit, in every layer.

mod common;

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use common::{BRUTE_FORCE, assert_same_bits, compare, gpu, mesh_scene, on_cpu, on_gpu, scene};
use glam::DVec3;
use rayproof::bounds::{Bounds, bound};
use rayproof::effects::Fetch;
use rayproof::flatten::flatten;
use rayproof::gpu::render::{Portions, render};
use rayproof::layout::Pixel;
use rayproof::scene::mesh::Builtin;
use rayproof::scene::{Falloff, Geometry, Light, MAX_LIGHTS};
use rayproof::{Backend, Error, Scene, Unwatched, Watch};

#[test]
fn seed_spheres() {
    let scene = scene("seed-spheres");
    assert_eq!((scene.image.width, scene.image.height), (1000, 1000));
    assert_same_bits(&on_gpu(&scene), &on_cpu(&scene));
}

#[test]
fn shapes() {
    let scene = scene("shapes");
    assert_eq!((scene.image.width, scene.image.height), (1000, 1000));
    assert_same_bits(&on_gpu(&scene), &on_cpu(&scene));
}

#[test]
fn seed_models() {
    let scene = scene("seed-models");
    assert_eq!((scene.image.width, scene.image.height), (500, 500));
    assert_same_bits(&on_gpu(&scene), &on_cpu(&scene));
}

#[test]
fn knot() {
    let scene = scene("knot");
    assert_eq!((scene.image.width, scene.image.height), (96, 96));
    assert_same_bits(&on_gpu(&scene), &on_cpu(&scene));
}

/// The control: a millionth of a unit is seen.
#[test]
fn one_moved_sphere_is_noticed() {
    let scene = scene("shapes").with_size(250, 250);
    let mut moved = scene.clone();
    let first = moved
        .shapes
        .iter_mut()
        .find_map(|shape| match &mut shape.geometry {
            Geometry::Sphere { center, .. } => Some(center),
            _ => None,
        });
    first.unwrap().x += 1e-6;
    let comparison = compare(&on_gpu(&moved), &on_cpu(&scene));
    assert!(comparison.different_pixels > 0 && !comparison.pass);
    assert_same_bits(&on_gpu(&moved), &on_cpu(&moved));
}

/// The control of the method: where the driver may rearrange sums, as plain WGSL
/// lets it, the self-check does not vouch for the bits.
#[test]
fn a_driver_that_may_rearrange_is_noticed() {
    let mut gpu = gpu();
    assert!(gpu.is_bit_exact(), "{:?}", gpu.arithmetic);
    let lavapipe = gpu.adapter.name.contains("llvmpipe");
    gpu.give_up_exactness().unwrap();
    assert!(!gpu.is_bit_exact());
    // SwiftShader rearranges nothing in any case.
    assert!(
        !(lavapipe && gpu.arithmetic.two_sum),
        "lavapipe is known to simplify TwoSum"
    );
}

/// Pictures whose width is no multiple of a workgroup, of one pixel, of one row.
#[test]
fn odd_sizes() {
    for (width, height) in [(1, 1), (37, 1), (1, 37), (61, 43), (200, 50)] {
        let scene = scene("shapes").with_size(width, height);
        assert_same_bits(&on_gpu(&scene), &on_cpu(&scene));
    }
}

#[test]
fn an_empty_scene_is_background() {
    let scene = Scene {
        shapes: Vec::new(),
        groups: Vec::new(),
        ..scene("shapes").with_size(40, 30)
    };
    let frame = on_gpu(&scene);
    assert_same_bits(&frame, &on_cpu(&scene));
    assert!(frame.depth.iter().all(|depth| depth.is_infinite()));
}

/// More triangles than lavapipe loops: right all the same, in small dispatches.
#[test]
fn two_hundred_thousand_triangles_without_volumes() {
    let scene = mesh_scene(Builtin::Icosphere, 200_000, 40);
    let flat = flatten::<f32>(&scene);
    assert_eq!(flat.triangles.len(), 200_000);
    let frame = on_gpu(&scene);
    assert_same_bits(&frame, &on_cpu(&scene));
    // Seen from inside the tests' order: hits among the last triangles too.
    assert!(frame.id.iter().any(|&id| id != u32::MAX && id > 150_000));
}

fn render_in(scene: &Scene, portions: Portions) -> Result<Vec<Pixel>, Error> {
    let mut pixels = Vec::new();
    render(
        &gpu(),
        &flatten::<f32>(scene),
        portions,
        &Unwatched,
        &mut |_, rows| {
            pixels.extend_from_slice(rows);
        },
    )?;
    Ok(pixels)
}

/// Shading loops over the lights, in one dispatch: the most that a scene may have
/// are all there.
#[test]
fn as_many_lights_as_allowed() {
    let mut scene = scene("shapes").with_size(24, 24);
    let color = [1.0 / MAX_LIGHTS as f64; 3];
    scene.lights = (0..MAX_LIGHTS)
        .map(|at| Light::Point {
            position: DVec3::new(at as f64 / MAX_LIGHTS as f64, 6.0, 5.0),
            color,
            falloff: Falloff::None,
            shadow: false,
        })
        .collect();
    assert_same_bits(&on_gpu(&scene), &on_cpu(&scene));
    scene.lights.push(scene.lights[0]);
    let error = scene.validate().unwrap_err().to_string();
    assert!(error.contains("60001 lights"), "{error}");
}

/// A dispatch that loops more often than the driver allows is an error, not a
/// wrong picture.
#[test]
fn a_spent_loop_budget_is_an_error() {
    let gpu = gpu();
    // One pixel, so that all primitives go into the first dispatch.
    let scene = mesh_scene(Builtin::Icosphere, 300_000, 1);
    let unbounded = Portions {
        primitives_per_dispatch: u32::MAX,
        ..Portions::default()
    };
    let outcome = render_in(&scene, unbounded);
    if gpu.arithmetic.loop_budget.is_some() {
        let error = outcome.expect_err("the driver stops loops").to_string();
        assert!(error.contains("of 297680 shape tests"), "{error}");
    } else {
        outcome.unwrap();
    }
    render_in(&scene, Portions::default()).unwrap();
}

/// However the primitives are cut into dispatches, and wherever the scene lies, the
/// picture is the same.
#[test]
fn dispatches_and_memories_do_not_show() {
    let shapes = scene("shapes").with_size(64, 64);
    let teapot = mesh_scene(Builtin::Teapot, 600, 48);
    for scene in [shapes, teapot] {
        let whole = render_in(&scene, Portions::default()).unwrap();
        for fetch in Fetch::ALL {
            let cut = Portions {
                primitives_per_dispatch: 100,
                fetch: Some(fetch),
                ..Portions::default()
            };
            assert_eq!(render_in(&scene, cut).unwrap(), whole, "{fetch:?}");
        }
    }
}

/// What does not fit is refused with figures.
#[test]
fn a_scene_too_large_for_its_memory_is_refused() {
    let portions = Portions {
        fetch: Some(Fetch::Uniform),
        ..Portions::default()
    };
    let scene = mesh_scene(Builtin::Icosphere, 20_000, 16);
    let error = render_in(&scene, portions).unwrap_err().to_string();
    assert!(error.contains("reads 65536 at most"), "{error}");
}

/// Destroys the device at the first sign of progress.
struct Destroyer<'a> {
    backend: &'a Backend,
    calls: AtomicUsize,
}

impl Watch for Destroyer<'_> {
    fn progress(&self, _done: f64) {
        if self.calls.fetch_add(1, Ordering::Relaxed) == 0 {
            let Backend::Gpu(gpu) = self.backend else {
                return;
            };
            gpu.destroy();
        }
    }
}

#[test]
fn a_lost_device_is_opened_anew() {
    let scene = mesh_scene(Builtin::Icosphere, 20_000, 64);
    let backend = Backend::Gpu(Box::new(gpu()));
    let watch = Destroyer {
        backend: &backend,
        calls: AtomicUsize::new(0),
    };
    let frame = rayproof::render(&scene, &backend, BRUTE_FORCE, &watch)
        .unwrap()
        .frame;
    assert_same_bits(&frame, &on_cpu(&scene));
    assert!(watch.calls.load(Ordering::Relaxed) > 1);
}

#[test]
fn a_lost_device_gives_no_picture() {
    let scene = mesh_scene(Builtin::Icosphere, 20_000, 64);
    let backend = Backend::Gpu(Box::new(gpu()));
    let watch = Destroyer {
        backend: &backend,
        calls: AtomicUsize::new(0),
    };
    let Backend::Gpu(device) = &backend else {
        unreachable!()
    };
    let mut rows = 0;
    let outcome = render(
        device,
        &flatten::<f32>(&scene),
        Portions::default(),
        &watch,
        &mut |_, _| rows += 1,
    );
    assert!(matches!(outcome, Err(Error::DeviceLost(_))), "{outcome:?}");
    assert_eq!(rows, 0);
}

/// Stops at the first sign of progress.
struct Impatient(AtomicUsize);

impl Watch for Impatient {
    fn progress(&self, _done: f64) {
        self.0.fetch_add(1, Ordering::Relaxed);
    }
    fn cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed) > 0
    }
}

#[test]
fn a_render_can_be_cancelled() {
    let scene = mesh_scene(Builtin::Icosphere, 20_000, 64);
    for backend in [Backend::Cpu(None), Backend::Gpu(Box::new(gpu()))] {
        let watch = Impatient(AtomicUsize::new(0));
        let outcome = rayproof::render(&scene, &backend, BRUTE_FORCE, &watch);
        assert!(matches!(outcome, Err(Error::Interrupted)));
    }
}

/// Keeps what it is told of the progress.
#[derive(Default)]
struct Listener(Mutex<Vec<f64>>);

impl Watch for Listener {
    fn progress(&self, done: f64) {
        self.0.lock().unwrap().push(done);
    }
}

/// A ray through a tree is one small piece of work, however many primitives
/// there are: few dispatches, and a progress that ends at the end.
#[test]
fn the_pace_of_a_tree_is_not_that_of_brute_force() {
    let gpu = gpu();
    let scene = mesh_scene(Builtin::Icosphere, 20_000, 512);
    let mut flat = flatten::<f32>(&scene);
    bound(&mut flat, Bounds::Tree);
    let listener = Listener::default();
    render(&gpu, &flat, Portions::default(), &listener, &mut |_, _| {}).unwrap();
    let told = listener.0.into_inner().unwrap();
    assert!((told[told.len() - 1] - 1.0).abs() < 1e-9, "{told:?}");
    // 64 would be tiles of the least height, 8 rows.
    assert!(told.len() < 40, "{} dispatches", told.len());
}

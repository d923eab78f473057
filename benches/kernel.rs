//! The intersections one by one, and the ways through the volumes, in f32 and f64.
//!
//! `cargo bench --bench kernel`. Every bench goes through the same 1,024 rays of a
//! picture; `items` are rays.

use std::sync::LazyLock;

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use rayproof::Scene;
use rayproof::bounds::{Bounds, bound};
use rayproof::cpu::search::Search;
use rayproof::cpu::wide::Wide;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::kernel::aabb::clip_to_box;
use rayproof::kernel::ball::meets_ball;
use rayproof::kernel::camera::{Ray, camera_ray};
use rayproof::kernel::disk::intersect_disk;
use rayproof::kernel::hit::{Hit, no_hit};
use rayproof::kernel::own_box::ball_box;
use rayproof::kernel::plane::intersect_plane;
use rayproof::kernel::probe::{Probe, probe_of};
use rayproof::kernel::real::Real;
use rayproof::kernel::sphere::intersect_sphere;
use rayproof::kernel::trace::find_hit;
use rayproof::kernel::triangle::intersect_triangle;
use rayproof::kernel::triangles::triangle_of;
use rayproof::kernel::vector::Vec3;
use rayproof::layout::{BallRecord, Sphere};

fn main() {
    divan::main();
}

/// Rays along a side; both sides together, the rays of a bench.
const SIDE: u32 = 32;

/// A width and its scenes, flattened once.
trait Width: Real {
    fn shapes() -> &'static Flat<Self>;
    fn knot() -> &'static Flat<Self>;
}

static SHAPES: LazyLock<(Flat<f32>, Flat<f64>)> = LazyLock::new(|| flattened("shapes"));
static KNOT: LazyLock<(Flat<f32>, Flat<f64>)> = LazyLock::new(|| flattened("knot"));

fn flattened(name: &str) -> (Flat<f32>, Flat<f64>) {
    let root = env!("CARGO_MANIFEST_DIR");
    let scene = Scene::load(format!("{root}/assets/scenes/{name}.toml")).expect("it is there");
    let scene = scene.with_size(SIDE, SIDE);
    (flatten(&scene), flatten(&scene))
}

impl Width for f32 {
    fn shapes() -> &'static Flat<Self> {
        &SHAPES.0
    }
    fn knot() -> &'static Flat<Self> {
        &KNOT.0
    }
}

impl Width for f64 {
    fn shapes() -> &'static Flat<Self> {
        &SHAPES.1
    }
    fn knot() -> &'static Flat<Self> {
        &KNOT.1
    }
}

fn rays<R: Real>(flat: &Flat<R>) -> Vec<Ray<R>> {
    let pixels = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)));
    pixels
        .map(|(x, y)| camera_ray(&flat.camera, flat.size, x, y))
        .collect()
}

fn probes<R: Real>(flat: &Flat<R>) -> Vec<Probe<R>> {
    rays(flat).into_iter().map(probe_of).collect()
}

/// Times `test` on each of the probes.
fn each<R: Real, T>(bencher: Bencher<'_, '_>, flat: &Flat<R>, test: impl Fn(Probe<R>) -> T + Sync) {
    let probes = probes(flat);
    bencher.counter(ItemsCount::new(probes.len())).bench(|| {
        for &probe in &probes {
            black_box(test(black_box(probe)));
        }
    });
}

#[divan::bench(types = [f32, f64])]
fn ray_prepared<R: Width>(bencher: Bencher<'_, '_>) {
    let rays = rays(R::shapes());
    bencher.counter(ItemsCount::new(rays.len())).bench(|| {
        for &ray in &rays {
            black_box(probe_of(black_box(ray)));
        }
    });
}

#[divan::bench(types = [f32, f64])]
fn sphere<R: Width>(bencher: Bencher<'_, '_>) {
    let flat = R::shapes();
    each(bencher, flat, |probe| {
        intersect_sphere(probe.ray, &flat.spheres[0])
    });
}

#[divan::bench(types = [f32, f64])]
fn plane<R: Width>(bencher: Bencher<'_, '_>) {
    let flat = R::shapes();
    let plane = &flat.planes[0];
    let (point, normal) = (Vec3::from(plane.point), Vec3::from(plane.normal));
    each(bencher, flat, |probe| {
        intersect_plane(probe.ray, point, normal)
    });
}

#[divan::bench(types = [f32, f64])]
fn disk<R: Width>(bencher: Bencher<'_, '_>) {
    let flat = R::shapes();
    each(bencher, flat, |probe| {
        intersect_disk(probe.ray, &flat.disks[0])
    });
}

#[divan::bench(types = [f32, f64])]
fn triangle<R: Width>(bencher: Bencher<'_, '_>) {
    let flat = R::shapes();
    let triangle = triangle_of(flat, flat.triangles[0]);
    each(bencher, flat, |probe| {
        intersect_triangle(probe.ray, probe.shear, &triangle)
    });
}

#[divan::bench(types = [f32, f64])]
fn bounding_ball<R: Width>(bencher: Bencher<'_, '_>) {
    let flat = R::shapes();
    let Sphere { center, radius, .. } = flat.spheres[0];
    let ball = BallRecord { center, radius };
    each(bencher, flat, |probe| meets_ball(probe.ray, &ball));
}

/// In f32 in both widths.
#[divan::bench]
fn bounding_box(bencher: Bencher<'_, '_>) {
    let flat = f32::shapes();
    let sphere = &flat.spheres[0];
    let own = ball_box::<f32>(Vec3::from(sphere.center), sphere.radius);
    each(bencher, flat, |probe| {
        clip_to_box(probe.slabs, own.low, own.high)
    });
}

/// The closest hit in a knot of 100,000 triangles, as the shader searches.
#[divan::bench(types = [f32, f64])]
fn search_pairs<R: Width>(bencher: Bencher<'_, '_>) {
    search(bencher, R::knot(), Bounds::Tree);
}

/// The closest hit in a knot of 100,000 triangles, as pictures are traced.
#[divan::bench(types = [f32, f64])]
fn search_wide<R: Width>(bencher: Bencher<'_, '_>) {
    let mut flat = R::knot().clone();
    bound(&mut flat, Bounds::Tree);
    let wide = Wide::new(&flat);
    let probes = probes(&flat);
    bencher
        .counter(ItemsCount::new(probes.len()))
        .bench_local(|| {
            let mut search = Search::new(&flat, Some(&wide));
            for &probe in &probes {
                let mut hit = no_hit();
                search.closest(black_box(probe), &mut hit);
                black_box(hit);
            }
        });
}

/// The closest hit among the shapes, without volumes.
#[divan::bench(types = [f32, f64])]
fn search_nothing<R: Width>(bencher: Bencher<'_, '_>) {
    search(bencher, R::shapes(), Bounds::None);
}

/// The closest hit in a knot of 100,000 triangles, in balls seven levels deep.
#[divan::bench(types = [f32, f64])]
fn search_balls<R: Width>(bencher: Bencher<'_, '_>) {
    search(bencher, R::knot(), Bounds::Spheres { levels: 7 });
}

/// The same in boxes.
#[divan::bench(types = [f32, f64])]
fn search_boxes<R: Width>(bencher: Bencher<'_, '_>) {
    search(bencher, R::knot(), Bounds::Boxes { levels: 7 });
}

fn search<R: Real>(bencher: Bencher<'_, '_>, flat: &Flat<R>, bounds: Bounds) {
    let mut flat = flat.clone();
    bound(&mut flat, bounds);
    each(bencher, &flat, |probe| -> Hit<R> {
        let mut hit = no_hit();
        find_hit(&flat, probe, &mut hit);
        hit
    });
}

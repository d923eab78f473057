//! The quad-tree over the screen: a tile knows of every volume that its rays meet.

mod common;

use common::random::random_scene;
use common::{changed, scene};
use rayproof::bounds::{Bounds, bound};
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::kernel::ball::meets_ball;
use rayproof::kernel::camera::camera_ray;
use rayproof::kernel::cone::{Cone, cone_meets_ball};
use rayproof::kernel::real::Real;
use rayproof::kernel::screen::{cone_of_tile, is_on_tile, tile_of};
use rayproof::layout::EVERYTHING;
use rayproof::render::{Settings, count};
use rayproof::{Accuracy, Backend, Scene, Unwatched};

fn divided<R: Real>(scene: &Scene) -> Flat<R> {
    let mut flat = flatten::<R>(scene);
    bound(&mut flat, Bounds::Screen { levels: 3 });
    assert!(flat.tile_words > 0);
    flat
}

/// Pairs of a ray and a volume that it meets, and those of them of which `knows`, given
/// the pixel and the volume's entry, says no; then all pairs.
fn missed<R: Real>(flat: &Flat<R>, knows: impl Fn(u32, u32, u32) -> bool) -> [usize; 3] {
    let [mut met, mut missed, mut pairs] = [0; 3];
    for (x, y) in (0..flat.size[1]).flat_map(|y| (0..flat.size[0]).map(move |x| (x, y))) {
        let ray = camera_ray(&flat.camera, flat.size, x, y);
        for (volume, entry) in flat.volumes.iter().zip(0..) {
            pairs += 1;
            if volume.bound != EVERYTHING && meets_ball(ray, &flat.balls[volume.bound as usize]) {
                met += 1;
                missed += usize::from(!knows(x, y, entry));
            }
        }
    }
    [met, missed, pairs]
}

fn check<R: Real>(scene: &Scene) {
    let flat = divided::<R>(scene);
    let by_mask = |x, y, entry| is_on_tile(&flat, tile_of(flat.size, x, y), entry);
    let [met, lost, _] = missed(&flat, by_mask);
    assert!(met > 0);
    assert_eq!(lost, 0);
}

#[test]
fn no_ray_meets_what_its_tile_does_not_know_of() {
    let mut met_by_any = 0;
    for seed in 0..10 {
        // Pictures that end within a tile, from a telescope to a fisheye.
        let mut scene = random_scene(seed, 10f64.powi(seed as i32 - 5)).with_size(61, 43);
        scene.camera.fov_degrees = [0.01, 3.0, 45.0, 120.0, 175.0][seed as usize % 5];
        if flatten::<f32>(&scene).primitives() == 0 {
            continue;
        }
        let [met, lost, _] = {
            let flat = divided::<f32>(&scene);
            missed(&flat, |x, y, entry| {
                is_on_tile(&flat, tile_of(flat.size, x, y), entry)
            })
        };
        assert_eq!(lost, 0, "seed {seed}, {met} met");
        met_by_any += met;
        let bounds = Bounds::Screen { levels: 3 };
        assert_eq!(changed::<f32>(&scene, bounds), 0, "seed {seed}");
        assert_eq!(changed::<f64>(&scene, bounds), 0, "seed {seed}");
    }
    assert!(met_by_any > 1000, "{met_by_any}");
    check::<f32>(&scene("seed-models").with_size(150, 150));
    check::<f64>(&scene("seed-spheres").with_size(150, 150));
}

/// The control: cones a tenth too narrow lose volumes.
#[test]
fn narrow_cones_are_noticed() {
    let flat = divided::<f32>(&scene("seed-models").with_size(150, 150));
    let knows = |x: u32, y: u32, entry: u32, factor: f32| {
        let cone = cone_of_tile(&flat, x / 8 * 8, y / 8 * 8, 8);
        let sine = cone.sine * factor;
        let cone = Cone { sine, ..cone };
        let bound = flat.volumes[entry as usize].bound;
        cone_meets_ball(&cone, &flat.balls[bound as usize])
    };
    let [met, lost, _] = missed(&flat, |x, y, entry| knows(x, y, entry, 1.0));
    assert!(met > 10_000);
    assert_eq!(lost, 0);
    let [_, lost, _] = missed(&flat, |x, y, entry| knows(x, y, entry, 0.9));
    assert!(lost > 0);
}

/// What it is for: most volumes are not tested by rays that miss them.
#[test]
fn rays_test_few_volumes() {
    let counters = |bounds| {
        let settings = Settings {
            accuracy: Accuracy::Robust,
            bounds,
            forced: rayproof::effects::EffectSet::NONE,
        };
        let cpu = Backend::Cpu(None);
        count(&scene("seed-spheres"), &cpu, settings, &Unwatched)
            .unwrap()
            .sum()
    };
    let spheres = counters(Bounds::Spheres { levels: 1 });
    let screen = counters(Bounds::Screen { levels: 1 });
    assert_eq!(spheres.bound_tests, 2_000_000);
    assert!(screen.bound_tests < 230_000, "{screen:?}");
    assert_eq!(screen.bound_hits, spheres.bound_hits);
    assert_eq!(screen.shape_tests, spheres.shape_tests);
}

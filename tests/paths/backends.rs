//! The GPU follows the very paths of the CPU.

use glam::DVec3;
use rayproof::accuracy::Widths;
use rayproof::bounds::Bounds;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::vector::{Vec3, vec3};
use rayproof::layout::NO_HIT;
use rayproof::paths::{Aim, Paths};
use rayproof::{Accuracy, Backend, Error};

use super::backends;
use super::common::aimed::{aimed_rays, hard_scene};
use super::common::random::Numbers;

/// Scenes at which rays are aimed: whether the scene is turned, its scale, and its volumes.
const SCENES: [(bool, f64, Bounds); 4] = [
    (false, 1.0, Bounds::Tree),
    (true, 1.0, Bounds::Tree),
    (true, 1e4, Bounds::Tree),
    (true, 1e-3, Bounds::None),
];

fn single_vector(v: DVec3) -> Vec3<f32> {
    let [x, y, z] = v.as_vec3().to_array();
    vec3(x, y, z)
}

/// An aim of every kind in turn.
fn aims(flat: &Flat<f64>, count: usize) -> Vec<Aim> {
    let mut n = Numbers(23);
    let size = DVec3::from(flat.disks[0].center).length();
    (0..count)
        .map(|index| match index % 5 {
            0 | 1 => Aim::Mirrored,
            2 => Aim::Towards(single_vector(n.vector(1.0))),
            3 => Aim::To(single_vector(n.vector(size))),
            _ => Aim::Refracted {
                ratio: n.between(0.5, 2.0) as f32,
            },
        })
        .collect()
}

fn follow(
    widths: &Widths,
    backend: &Backend,
    accuracy: Accuracy,
    rays: &[Ray<f32>],
    legs: u32,
) -> Paths {
    let aims = aims(&widths.double, rays.len());
    widths
        .follow_paths(backend, accuracy, rays, &aims, legs)
        .unwrap()
}

/// Every bit of a path.
fn bits(paths: &Paths) -> Vec<[u64; 2]> {
    let found = paths.found.iter();
    let found = found.map(|found| [found.t.to_bits(), found.id.into()]);
    let ends = paths
        .ends
        .iter()
        .flat_map(|ray| [ray.origin, ray.direction]);
    let numbers = ends.flat_map(<[f32; 3]>::from);
    found
        .chain(numbers.map(|number| [number.to_bits().into(), 0]))
        .collect()
}

#[test]
fn both_backends_follow_the_same_paths() {
    let [cpu, gpu] = backends();
    let legs = 5;
    for (turned, scale, bounds) in SCENES {
        let widths = Widths::of(flatten(&hard_scene(turned, scale)), bounds);
        let rays = aimed_rays(&widths.double, 3000, 17);
        for accuracy in Accuracy::ALL {
            // Its tree may lose a hit, and the CPU has another tree.
            if accuracy == Accuracy::Textbook && bounds == Bounds::Tree {
                continue;
            }
            let [on_cpu, on_gpu] =
                [&cpu, &gpu].map(|backend| follow(&widths, backend, accuracy, &rays, legs));
            let case = format!("{turned}, {scale:e}, {bounds:?}, {accuracy:?}");
            let (left, right) = (bits(&on_cpu), bits(&on_gpu));
            let differing = left.iter().zip(&right).filter(|(a, b)| a != b).count();
            assert_eq!(differing, 0, "{case}");
            assert_eq!(left.len(), right.len());
            assert_eq!(on_cpu.retraced, on_gpu.retraced, "{case}");
            // The controls: paths go on, and end; and a moved ray is noticed.
            let last = on_cpu.found.chunks(legs as usize).map(|legs| legs[4].id);
            let lost = last.filter(|&id| id == NO_HIT).count();
            assert!(lost > 300 && lost < 2900, "{case}: {lost}");
            let mut moved = rays.clone();
            moved[7].origin.x = moved[7].origin.x.next_up();
            moved[7].direction.y = moved[7].direction.y.next_up();
            assert_ne!(left, bits(&follow(&widths, &cpu, accuracy, &moved, legs)));
        }
    }
}

/// A path is its legs, one after the other: each is the ray at which the one before it ends.
#[test]
fn a_path_is_its_legs() {
    let [cpu, gpu] = backends();
    // Past the legs that are followed at once.
    let legs = 40;
    let widths = Widths::of(flatten(&hard_scene(true, 1.0)), Bounds::Tree);
    let rays = aimed_rays(&widths.double, 500, 29);
    for accuracy in [Accuracy::Robust, Accuracy::Extended, Accuracy::Double] {
        let whole = follow(&widths, &gpu, accuracy, &rays, legs);
        assert_eq!(
            bits(&whole),
            bits(&follow(&widths, &cpu, accuracy, &rays, legs))
        );
        let mut rays = rays.clone();
        for leg in 0..legs {
            let one = follow(&widths, &cpu, accuracy, &rays, 1);
            for (ray, found) in one.found.iter().enumerate() {
                let of_path = whole.found[ray * legs as usize + leg as usize];
                assert_eq!(of_path, *found, "{accuracy:?}, ray {ray}, leg {leg}");
            }
            rays = one.ends;
        }
        assert_eq!(rays, whole.ends);
        let hits = whole.found.iter().filter(|found| found.id != NO_HIT);
        assert!(hits.count() > 2000);
    }
}

/// What each leg of an adaptive path finds is what `double` finds on the same ray.
#[test]
fn adaptive_legs_find_what_double_finds() {
    let cpu = Backend::Cpu(None);
    let (mut hits, mut differing) = (0, 0);
    for (turned, scale, bounds) in SCENES {
        let widths = Widths::of(flatten(&hard_scene(turned, scale)), bounds);
        let mut rays = aimed_rays(&widths.double, 10_000, 31);
        for leg in 0..4 {
            let on_the_way = |paths: Paths| {
                let ids: Vec<u32> = paths.found.iter().map(|found| found.id).collect();
                (ids, paths.ends)
            };
            let [(adaptive, ends), (double, _), (robust, _)] =
                [Accuracy::Adaptive, Accuracy::Double, Accuracy::Robust]
                    .map(|accuracy| on_the_way(follow(&widths, &cpu, accuracy, &rays, 1)));
            assert_eq!(adaptive, double, "{turned}, {scale:e}, leg {leg}");
            differing += robust.iter().zip(&double).filter(|(a, b)| a != b).count();
            hits += double.iter().filter(|&&id| id != NO_HIT).count();
            rays = ends;
        }
    }
    // The controls.
    assert!(hits > 50_000 && differing > 100, "{hits} {differing}");
}

#[test]
fn what_is_no_path_is_refused() {
    let [cpu, gpu] = backends();
    let widths = Widths::of(flatten(&hard_scene(true, 1.0)), Bounds::Tree);
    let rays = aimed_rays(&widths.double, 10, 1);
    let aims = [Aim::Mirrored; 10];
    for backend in [&cpu, &gpu] {
        let follow =
            |aims: &[Aim], legs| widths.follow_paths(backend, Accuracy::Robust, &rays, aims, legs);
        for refused in [follow(&aims[1..], 1), follow(&aims, 0)] {
            assert!(matches!(refused, Err(Error::Usage(_))));
        }
        assert_eq!(follow(&aims, 3).unwrap().found.len(), 30);
        let none = widths.follow_paths(backend, Accuracy::Adaptive, &[], &[], 3);
        assert!(none.unwrap().ends.is_empty());
    }
}

//! Trees over boxes that cannot be told apart, or that are none.

use glam::DVec3;

use crate::bounds::Bounds;
use crate::error::Result;
use crate::kernel::aabb::Aabb;
use crate::kernel::vector::vec3;
use crate::random::Numbers;
use crate::stability::aim::{on_an_edge, passing, ray_to};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, BruteForce, Classified, Exact, Own};
use crate::stability::shapes::{flat_of, scene_of, sphere, triangle};
use crate::stability::trials::aimed::Aimed;
use crate::stability::trials::grown::Grown;
use crate::stability::trials::together::Together;
use crate::tier::Accuracy::Textbook;

pub(super) const CASES: &[Case] = &[
    Case {
        id: "bounds/odd-boxes",
        name: "boxes that are points, empty or infinite",
        sets_up: "Trees over 1 to 2000 boxes without extent, of negative, and without end, \
                  also among others.",
        danger: "The surface area is 0, infinite or NaN: no split is best, and the builder \
                 does not end.",
        demands: &[Own(
            "the tree ends, holds each box once and is no deeper than the stack",
        )],
        fails: &[],
        is_random: true,
        trial: odd_boxes,
    },
    Case {
        id: "bounds/equal-centroids",
        name: "10,000 spheres around one point",
        sets_up: "Concentric spheres of radius 1 to 2, and rays at them.",
        danger: "No plane parts their middles: a leaf of 10,000, or a path as deep.",
        demands: &[
            Classified,
            BruteForce,
            Own("no path of the tree is deeper than the stack"),
        ],
        fails: &[],
        is_random: true,
        trial: equal_centroids,
    },
    Case {
        id: "bounds/equal-shapes",
        name: "one triangle 1000 times",
        sets_up: "1000 times the same triangle, and rays into it.",
        danger: "All boxes are one, and the order of the tree decides who wins.",
        // Aimed at the middle: nothing near an edge.
        demands: &[Exact, BruteForce],
        fails: &[],
        is_random: true,
        trial: equal_shapes,
    },
    Case {
        id: "bounds/all-scales",
        name: "shapes from 1e-12 to 1e12",
        sets_up: "Triangles that double in size and distance, 80 times, and rays at their edges.",
        danger: "Bins of equal width hold all but one: the tree is as deep as a list. Planes in \
                 bytes have one step for large and small.",
        demands: &[Classified, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: all_scales,
    },
];

fn odd_boxes(n: &mut Numbers, _: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let all = |x: f32| vec3(x, x, x);
    let aabb = |low: f32, high: f32| Aabb {
        low: all(low),
        high: all(high),
    };
    let odd = [
        aabb(1.0, 1.0),
        aabb(0.0, -0.0),
        aabb(1.0, -1.0),
        aabb(f32::MAX, f32::MIN),
        aabb(f32::INFINITY, f32::NEG_INFINITY),
        aabb(f32::MIN, f32::MAX),
        aabb(f32::NEG_INFINITY, f32::INFINITY),
        aabb(0.0, f32::INFINITY),
        aabb(1e-40, 2e-40),
    ];
    let mut usual = || {
        let low: [f32; 3] = n.vector(9.0).as_vec3().to_array();
        Aabb {
            low: low.into(),
            high: low.map(|low| low + 0.5).into(),
        }
    };
    let mut lists = Vec::new();
    for aabb in odd {
        for count in [1, 2, 3, 5, 9, 100, 2000] {
            lists.push(vec![aabb; count]);
            let mixed = (0..count).map(|index| if index % 3 == 0 { aabb } else { usual() });
            lists.push(mixed.collect());
        }
    }
    lists.push((0..2000).map(|index| odd[index % odd.len()]).collect());
    // Each twice as large as the one before.
    lists.push((-120..120).map(|k| aabb(0.0, 2f32.powi(k))).collect());
    Ok(Box::new(Grown(lists)))
}

fn equal_centroids(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    const COUNT: u32 = 10_000;
    let middle = DVec3::new(0.5, -0.25, -6.0);
    let radius = |index: u32| 1.0 + f64::from(index) / f64::from(COUNT);
    let shells = (0..COUNT).map(|index| sphere(middle, radius(index)));
    let flat = flat_of(&scene_of(shells));
    let rays = (0..64)
        .map(|_| {
            let from = middle + n.direction() * n.between(0.0, 5.0).max(2.5);
            let impact = n.between(0.0, 2.2);
            passing(from, middle, impact, n)
        })
        .collect();
    let boxes = (0..COUNT).map(|index| {
        let [low, high] = [-1.0, 1.0].map(|side| middle + DVec3::splat(side * radius(index)));
        let [low, high] = [low, high].map(|corner| corner.as_vec3().to_array().into());
        Aabb { low, high }
    });
    Ok(Box::new(Together(vec![
        Box::new(Grown(vec![boxes.collect()])),
        Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?),
    ])))
}

fn equal_shapes(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let corners = [
        DVec3::new(-1.0, -1.0, -4.0),
        DVec3::new(1.5, -1.0, -5.0),
        DVec3::new(0.0, 2.0, -6.0),
    ];
    let flat = flat_of(&scene_of((0..1000).map(|_| triangle(corners))));
    let middle: DVec3 = corners.iter().sum::<DVec3>() / 3.0;
    let rays = (0..32)
        .map(|_| ray_to(n.vector(1.0), middle + n.vector(0.2)))
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

fn all_scales(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let shape = |power: i32| {
        let scale = 2f64.powi(power);
        let middle = n.direction() * 2.0;
        triangle([0; 3].map(|_| (middle + n.direction()) * scale))
    };
    let flat = flat_of(&scene_of((-40..40).map(shape)));
    let rays = (0..5000)
        .map(|_| {
            let target = on_an_edge(&flat, n);
            let start = n.vector(1.0) * target.length() * 10f64.powf(n.between(-3.0, 1.0));
            ray_to(start, target)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

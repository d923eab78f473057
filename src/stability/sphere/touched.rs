//! Spheres that are just touched: by rays, and by one another.

use glam::DVec3;

use super::spheres;
use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::kernel::camera::Ray;
use crate::random::Numbers;
use crate::render::Accuracy::Textbook;
use crate::stability::RAYS;
use crate::stability::aim::{across, passing, ray, ray_to, step};
use crate::stability::axes::frame;
use crate::stability::case::Case;
use crate::stability::demand::Demand::{BruteForce, Classified, Exact, Own, Residual};
use crate::stability::shapes::ASIDE;
use crate::stability::trials::aimed::Aimed;
use crate::stability::trials::aimed::aimed;
use crate::stability::trials::monotone::Monotone;
use crate::stability::trials::together::Together;

/// Where the sphere stands that integer rays touch, of radius 15.
const CENTER: DVec3 = DVec3::new(20.0, -30.0, -100.0);
const RADIUS: f64 = 15.0;

pub(super) const TANGENT: Case = Case {
    id: "sphere/tangent",
    name: "rays that touch a sphere, all numbers integers",
    sets_up: "Rays in 7 kinds of directions, whose nearest point is 15 from the centre exactly.",
    danger: "Code that asks for a discriminant above 0 misses; so does any rounding of it.",
    demands: &[Exact],
    fails: &[],
    is_random: true,
    trial: |n, demands| {
        let rays = (0..2000).map(|_| tangent(n)).collect();
        aimed(spheres([(CENTER, RADIUS)]), rays, demands)
    },
};

pub(super) const TANGENT_ULP: Case = Case {
    id: "sphere/tangent-ulp",
    name: "the same rays, and a radius 1 or 2 ulp larger or smaller",
    sets_up: "Four spheres, one after another.",
    danger: "|f|^2 - r^2 rounds the ulp away, and r is what it was.",
    fails: &[Textbook],
    trial: |n, demands| {
        let mut trials = Vec::new();
        for ulps in [-2, -1, 1, 2] {
            let rays = (0..1000).map(|_| tangent(n)).collect();
            let flat = spheres([(CENTER, step(RADIUS, ulps))]);
            trials.push(aimed(flat, rays, demands)?);
        }
        Ok(Box::new(Together(trials)))
    },
    ..TANGENT
};

pub(super) const GROWING: Case = Case {
    id: "sphere/growing",
    name: "a sphere that grows by an ulp at a time",
    sets_up: "Five radii, and rays at the rim of the one in the middle.",
    danger: "Code that scales the ray by 1/r, as for an instance of a unit sphere, rounds anew \
             for each radius: a larger sphere is missed.",
    demands: &[Own(
        "a ray that meets a sphere meets each larger one, and no later",
    )],
    trial: |n, _| {
        let (center, radius) = (ASIDE * 10.0, 1.3);
        let growing = (-2..=2).map(|ulps| {
            let flat = spheres([(center, step(radius, ulps))]);
            Widths::of(flat, Bounds::None)
        });
        let growing: Vec<Widths> = growing.collect();
        let middle = DVec3::from(growing[2].double.spheres[0].center);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let past = n.between(-1e-6, 1e-6);
                passing(DVec3::ZERO, middle, radius * (1.0 + past), n)
            })
            .collect();
        Ok(Box::new(Monotone { growing, rays }))
    },
    ..TANGENT
};

pub(super) const SHELLS: Case = Case {
    id: "sphere/shells",
    name: "two concentric spheres, 0.00004 apart",
    sets_up: "Rays that start between them and go in or out.",
    danger: "A smallest t of 10^-3 skips the shell next to the start.",
    demands: &[Classified, Residual(4.0)],
    trial: |n, demands| {
        let flat = shells();
        let center = DVec3::from(flat.spheres[0].center);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let from = center + n.direction() * n.between(1.0 - 3e-5, 1.0 - 1e-5);
                ray(from, n.direction())
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..TANGENT
};

pub(super) const GAP_BETWEEN_SHELLS: Case = Case {
    id: "sphere/gap-between-shells",
    name: "rays through the gap between the two",
    sets_up: "Rays that start inside the inner one or far off and pass the centre at 0.9999 to \
              1.0001.",
    danger: "The discriminant is 10^-4 at most: a threshold for it takes the gap away.",
    demands: &[Classified],
    trial: |n, demands| {
        let flat = shells();
        let center = DVec3::from(flat.spheres[0].center);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let from = center + n.direction() * n.between(1.1, 4.0);
                passing(from, center, n.between(0.9999, 1.0001), n)
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..SHELLS
};

pub(super) const EQUAL: Case = Case {
    id: "sphere/equal",
    name: "three spheres in one place",
    sets_up: "Rays at them, through the tree and by brute force.",
    danger: "The last of equals wins where t <= best is asked, and the order of a tree decides \
             where the ids do not.",
    demands: &[Exact, BruteForce],
    trial: |n, demands| {
        let flat = spheres([(ASIDE * 5.0, 1.0); 3]);
        let center = DVec3::from(flat.spheres[0].center);
        let rays = (0..RAYS / 5)
            .map(|_| passing(DVec3::ZERO, center, n.between(0.0, 0.99), n))
            .collect();
        Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
    },
    ..TANGENT
};

pub(super) const KISSING: Case = Case {
    id: "sphere/kissing",
    name: "two unit spheres that touch",
    sets_up: "Rays from all around at the point where they do, missing it by up to 10^-3.",
    danger: "Both are grazed at once, and either may be lost.",
    demands: &[Classified],
    trial: |n, demands| {
        // All these numbers are exact in f32.
        let touch = DVec3::new(0.5, -0.25, -6.0);
        let flat = spheres([(touch - DVec3::X, 1.0), (touch + DVec3::X, 1.0)]);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let from = touch + across(DVec3::X, n) * n.between(1.5, 5.0) + n.vector(0.2);
                let past = 10f64.powf(n.between(-8.0, -3.0));
                ray_to(from, touch + n.direction() * past)
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..TANGENT
};

fn shells() -> crate::flat::Flat<f64> {
    spheres([(ASIDE * 3.0, 1.0), (ASIDE * 3.0, 1.0 - 4e-5)])
}

/// A ray of integers that touches the sphere of radius 15.
fn tangent(n: &mut Numbers) -> Ray<f32> {
    let ([along, left, up], length) = frame(n);
    let triples = [
        (15.0, 0.0),
        (9.0, 12.0),
        (12.0, 9.0),
        (-9.0, 12.0),
        (12.0, -9.0),
    ];
    let (a, b) = triples[n.pick(triples.len())];
    let back = (20.0 + n.pick(180) as f64) / length;
    let from = CENTER - along * back.floor() + (left * a + up * b) / length;
    ray(from, along)
}

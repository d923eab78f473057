//! The rims of disks, large and small.

use glam::DVec3;

use super::rounded;
use crate::error::Result;
use crate::random::Numbers;
use crate::render::Accuracy::{Robust, Textbook};
use crate::stability::RAYS;
use crate::stability::aim::{across, ray, ray_to, step};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, Classified, ClassifiedClearly, Exact, Residual};
use crate::stability::shapes::{ASKEW, disk};
use crate::stability::trials::aimed::aimed;
use crate::stability::trials::together::Together;

pub(super) const EXACT: Case = Case {
    id: "flat/rim",
    name: "the rim of a disk, all numbers integers",
    sets_up: "Rays that reach a point of the rim, such as (9, 12), at t = 1 exactly.",
    danger: "The rim belongs to the disk: code that asks for less than r has a hairline around \
             it.",
    demands: &[Exact],
    fails: &[],
    is_random: true,
    trial: |n, demands| at_rim(n, demands, &[0]),
};

pub(super) const ULP: Case = Case {
    id: "flat/rim-ulp",
    name: "the same rays, and a radius 1 or 2 ulp larger or smaller",
    sets_up: "Four disks, one after another.",
    danger: "A tolerance for the rim takes the smaller disk for the larger.",
    trial: |n, demands| at_rim(n, demands, &[-2, -1, 1, 2]),
    ..EXACT
};

pub(super) const AIMED: Case = Case {
    id: "flat/rim-aimed",
    name: "the rim of a unit disk",
    sets_up: "Rays from all around that pass the rim at up to 10^-8 to 10^-2, some of them \
              nearly in the disk's plane.",
    danger: "Nearly edge-on, an error of t is a much larger one of the point.",
    demands: &[Classified, Residual(4.0)],
    trial: |n, demands| {
        let flat = rounded([disk(ASKEW * -4.0, ASKEW, 1.0)]);
        let center = DVec3::from(flat.disks[0].center);
        let normal = DVec3::from(flat.disks[0].normal);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let past = 10f64.powf(n.between(-8.0, -2.0));
                let past = if n.flip() { past } else { -past };
                let rim = center + across(normal, n) * (1.0 + past);
                let slope = 10f64.powf(n.between(-4.0, 1.0));
                let away = across(normal, n) + normal * slope;
                ray_to(rim + away.normalize() * n.between(1.0, 6.0), rim)
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..EXACT
};

pub(super) const TINY: Case = Case {
    id: "flat/tiny-disk",
    name: "a disk of radius 0.000001, 1,000 away",
    sets_up: "Rays from the camera at it and at its rim.",
    danger: "The disk is smaller than the rounding of its centre: f32 cannot tell hit from miss.",
    demands: &[ClassifiedClearly],
    fails: &[Textbook, Robust],
    trial: |n, demands| {
        let flat = rounded([disk(ASKEW * 1e3, DVec3::new(0.3, 0.7, 0.5), 1e-6)]);
        let center = DVec3::from(flat.disks[0].center);
        let rays = (0..RAYS)
            .map(|_| {
                let to_rim = across(center, n) * (1e-6 * n.between(0.0, 2.0));
                // Rounded, few rays are left that do not miss, and t is not 1.
                ray(DVec3::ZERO, (center + to_rim) * n.between(5e-4, 2e-3))
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..EXACT
};

pub(super) const SMALLEST: Case = Case {
    id: "flat/smallest",
    name: "a disk of the least radius, 10^-15",
    sets_up: "Rays from around it that reach it, or nearly so, at t = 1.",
    danger: "d.n is 10^-14 as the scene is: any threshold for it is larger.",
    demands: &[Classified, Residual(4.0)],
    fails: &[Textbook],
    trial: |n, demands| at_scale(1e-15, n, demands),
    ..EXACT
};

pub(super) const LARGEST: Case = Case {
    id: "flat/largest",
    name: "a disk at the largest coordinates, 10^15",
    danger: "Squares are 10^30: one more product overflows in f32.",
    fails: &[],
    trial: |n, demands| at_scale(3e13, n, demands),
    ..SMALLEST
};

/// Integer rays at the rim of a disk of radius 15 that lies level, for each of so many ulp more.
fn at_rim(n: &mut Numbers, demands: &[Demand], ulps: &[i32]) -> Result<Box<dyn Trial>> {
    let center = DVec3::new(20.0, -30.0, -40.0);
    let integer = |n: &mut Numbers| n.vector(40.0).round();
    let triples = [
        (9.0, 12.0),
        (12.0, -9.0),
        (-9.0, 12.0),
        (0.0, 15.0),
        (-15.0, 0.0),
    ];
    let mut trials = Vec::new();
    for &ulps in ulps {
        let flat = rounded([disk(center, DVec3::Y, step(15.0, ulps))]);
        let rays = (0..1000)
            .map(|_| {
                let (x, z) = triples[n.pick(triples.len())];
                let rim = center + DVec3::new(x, 0.0, z);
                let height = (1 + n.pick(60)) as f64;
                let from = integer(n).with_y(center.y + if n.flip() { height } else { -height });
                // t is then 2, 1 or 1/2.
                ray(from, (rim - from) * 2f64.powi(n.pick(3) as i32 - 1))
            })
            .collect();
        trials.push(aimed(flat, rays, demands)?);
    }
    Ok(Box::new(Together(trials)))
}

/// Rays from around a disk of such a radius, as far from the camera as 30 of it.
fn at_scale(radius: f64, n: &mut Numbers, demands: &[Demand]) -> Result<Box<dyn Trial>> {
    let flat = rounded([disk(ASKEW * (30.0 * radius), ASKEW, radius)]);
    let center = DVec3::from(flat.disks[0].center);
    let normal = DVec3::from(flat.disks[0].normal);
    let rays = (0..RAYS / 5)
        .map(|_| {
            let away = n.direction() * (n.between(2.0, 20.0) * radius);
            let point = center + across(normal, n) * (n.between(0.0, 1.2) * radius);
            ray_to(center + away, point)
        })
        .collect();
    aimed(flat, rays, demands)
}

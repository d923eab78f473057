//! Planes and disks far off, behind, upon one another, and of any length of normal.

use glam::DVec3;

use super::rounded;
use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::random::Numbers;
use crate::render::Accuracy::Textbook;
use crate::stability::RAYS;
use crate::stability::aim::{across, ray, ray_to};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{
    BruteForce, ClassifiedWithin, Distance, Exact, Residual, Same,
};
use crate::stability::shapes::{ASKEW, disk, plane};
use crate::stability::trials::aimed::Aimed;
use crate::stability::trials::aimed::aimed;
use crate::stability::trials::alike::Alike;

// The start is at most 4 heights from the plane's point: 4 u |n| |p - o| is 16 u of the height.
// The slope is at least 0.3 |n| |d|: 3 u |n| |d| is 10 u of it. The quotient takes another.
pub(super) const PLANE_1E6: Case = Case {
    id: "flat/plane-1e6",
    name: "a plane 1,000,000 away that rays start 1 above",
    sets_up: "Rays that fall by 0.3 to 1 of their length.",
    danger: "n.p - n.o subtracts two numbers of 10^6 to learn of one; n.(p - o) does not.",
    demands: &[Exact, Distance(28.0)],
    fails: &[],
    is_random: true,
    trial: |n, demands| {
        let flat = rounded([plane(ASKEW * 1e6, ASKEW)]);
        let point = DVec3::from(flat.planes[0].point);
        let normal = DVec3::from(flat.planes[0].normal);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let aside = across(normal, n) * n.between(0.0, 3.0);
                let fall = n.between(0.3, 1.0);
                let way = across(normal, n) * (1.0 - fall * fall).sqrt() - normal * fall;
                ray(point + normal * n.between(1.0, 2.0) + aside, way)
            })
            .collect();
        aimed(flat, rays, demands)
    },
};

// The point is off by 4 u (|f| + t |d|) from t, as f.n is all of |f| at most, and by 6 u of the
// same: together below 10 u of 20, and B is above 2e6.
pub(super) const DISK_1E6: Case = Case {
    id: "flat/disk-1e6",
    name: "a unit disk next to the rays, 1,000,000 from the camera",
    sets_up: "Rays that start 2 to 8 away, not more than 60 degrees from the normal, and pass \
              the rim at up to 10^-6 to 10^-1.",
    danger: "(o + t d) - c rounds to parts of 10^6 before it subtracts; (o - c) + t d does not.",
    demands: &[ClassifiedWithin(1e-4), Residual(4.0)],
    trial: |n, demands| {
        let flat = rounded([disk(ASKEW * 1e6, ASKEW, 1.0)]);
        let center = DVec3::from(flat.disks[0].center);
        let normal = DVec3::from(flat.disks[0].normal);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let past = 10f64.powf(n.between(-6.0, -1.0));
                let past = if n.flip() { past } else { -past };
                let rim = across(normal, n) * (1.0 + past);
                let away = normal + across(normal, n) * n.between(0.0, 1.7);
                let from = center + away * n.between(2.0, 4.0);
                let from = from.as_vec3().as_dvec3();
                ray_to(from, center + rim)
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..PLANE_1E6
};

pub(super) const BEHIND: Case = Case {
    id: "flat/behind",
    name: "a plane and a disk behind the start",
    sets_up: "Rays away from both, from either side.",
    danger: "t is below 0, and the distance from the centre does not tell.",
    demands: &[Exact],
    trial: |n, demands| {
        let flat = rounded([plane(ASKEW * -3.0, ASKEW), disk(ASKEW * 3.0, ASKEW, 2.0)]);
        let rays = (0..2000)
            .map(|_| {
                let (height, side) = if n.flip() { (3.1, 1.0) } else { (-3.1, -1.0) };
                let from = ASKEW * height + across(ASKEW, n) * n.between(0.0, 1.0);
                let way = ASKEW * (side * n.between(0.1, 1.0)) + across(ASKEW, n);
                ray(from, way)
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..PLANE_1E6
};

pub(super) const COPLANAR: Case = Case {
    id: "flat/disk-in-plane",
    name: "a disk in a plane",
    sets_up: "Both level, so that t is the same number; rays at the disk and past it.",
    danger: "Where the last of equals wins, or the nearer by a rounding, the two flicker.",
    demands: &[Exact],
    trial: |n, demands| {
        let low = DVec3::new(0.0, -2.0, 0.0);
        let flat = rounded([
            disk(low + DVec3::new(1.0, 0.0, -4.0), DVec3::Y, 2.0),
            plane(low, DVec3::Y),
        ]);
        let rays = (0..2000)
            .map(|_| {
                let target = DVec3::new(1.0, -2.0, -4.0) + n.vector(3.0).with_y(0.0);
                ray_to(n.vector(1.0), target)
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..PLANE_1E6
};

pub(super) const EQUAL: Case = Case {
    id: "flat/equal-disks",
    name: "three disks in one place",
    sets_up: "Rays at them, through the tree and by brute force.",
    danger: "The last of equals wins where t <= best is asked, and the order of a tree decides \
             where the ids do not.",
    demands: &[Exact, BruteForce],
    trial: |n, demands| {
        let flat = rounded([(); 3].map(|()| disk(ASKEW * -5.0, ASKEW, 1.0)));
        let center = DVec3::from(flat.disks[0].center);
        let normal = DVec3::from(flat.disks[0].normal);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let aside = across(normal, n) * n.between(0.0, 0.9);
                ray_to(n.vector(1.0), center + aside)
            })
            .collect();
        Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
    },
    ..PLANE_1E6
};

pub(super) const NORMAL_LENGTH: Case = Case {
    id: "flat/normal-length",
    name: "normals 2^33 times as long, or as short",
    sets_up: "A plane and a disk, each ray twice; the scale is a power of two, so no rounding \
              changes.",
    danger: "A threshold for d.n takes a short normal for a parallel ray.",
    demands: &[Same(0.0)],
    fails: &[Textbook],
    trial: |n, _| {
        let mut scaled = shapes();
        let factor = 2f64.powi(if n.flip() { 33 } else { -33 });
        scaled.planes[0].normal = scaled.planes[0].normal.map(|x| x * factor);
        scaled.disks[0].normal = scaled.disks[0].normal.map(|x| x / factor);
        let rays = rays_at_shapes(n);
        let scale = vec![1.0; rays.len()];
        same((shapes(), rays.clone()), (scaled, rays), scale)
    },
    ..PLANE_1E6
};

pub(super) const DIRECTION_LENGTH: Case = Case {
    id: "flat/direction-length",
    name: "directions 2^33 times as long, or as short",
    sets_up: "As before, but it is the rays' directions that are scaled.",
    danger: "A threshold for d.n takes a short direction for a parallel ray.",
    trial: |n, _| {
        let rays = rays_at_shapes(n);
        let scale: Vec<f64> = rays
            .iter()
            .map(|_| 2f64.powi(if n.flip() { 33 } else { -33 }))
            .collect();
        let scaled = rays.iter().zip(&scale).map(|(ray, scale)| Ray {
            direction: ray.direction * (1.0 / scale) as f32,
            ..*ray
        });
        let scaled = scaled.collect();
        same((shapes(), rays), (shapes(), scaled), scale)
    },
    ..NORMAL_LENGTH
};

/// A plane behind a disk.
fn shapes() -> Flat<f64> {
    rounded([
        plane(ASKEW * -6.0, ASKEW),
        disk(ASKEW * -5.0, DVec3::new(0.3, 0.7, 0.5), 1.0),
    ])
}

/// Rays at both.
fn rays_at_shapes(n: &mut Numbers) -> Vec<Ray<f32>> {
    let at = |n: &mut Numbers| ray_to(n.vector(1.0), ASKEW * -5.0 + n.vector(1.2));
    (0..RAYS / 5).map(|_| at(n)).collect()
}

type RaysAt = (Flat<f64>, Vec<Ray<f32>>);

fn same(left: RaysAt, right: RaysAt, scale: Vec<f64>) -> Result<Box<dyn Trial>> {
    let with_rays = |(flat, rays): RaysAt| (Widths::of(flat, Bounds::None), rays);
    Ok(Box::new(Alike {
        left: with_rays(left),
        right: with_rays(right),
        scale,
        roundings: 0.0,
    }))
}

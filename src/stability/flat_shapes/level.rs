//! Rays in a plane, on it, or nearly along it.

use glam::DVec3;

use super::rounded;
use crate::error::Result;
use crate::kernel::camera::Ray;
use crate::random::Numbers;
use crate::render::Accuracy::Textbook;
use crate::scene::Geometry;
use crate::stability::RAYS;
use crate::stability::aim::{across, ray};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, Classified, Distance, Exact, Finite, Residual};
use crate::stability::shapes::{disk, plane};
use crate::stability::trials::aimed::aimed;
use crate::stability::trials::together::Together;

/// The normal of the oblique planes. Rounded, it is the f32 nearest 1/3 times these.
const OBLIQUE: DVec3 = DVec3::new(1.0, 2.0, 2.0);

/// Directions in an oblique plane, whose products with the normal need no rounding.
const LEVEL: [DVec3; 3] = [
    DVec3::new(2.0, 1.0, -2.0),
    DVec3::new(2.0, -2.0, 1.0),
    DVec3::new(4.0, -1.0, -1.0),
];

pub(super) const IN_PLANE: Case = Case {
    id: "flat/in-plane",
    name: "rays in a plane, and beside it",
    sets_up: "A plane through the camera and one below it; d.n is exactly 0.",
    danger: "0 / 0 is no number and h / 0 is infinity, and both pass some test of t.",
    demands: &[Exact, Finite],
    fails: &[],
    is_random: true,
    trial: |n, demands| {
        let oblique = (0..1000).map(|_| {
            let from = level(n) + if n.flip() { n.vector(3.0) } else { DVec3::ZERO };
            ray(from, level(n))
        });
        let oblique = oblique.collect();
        let below = (0..1000).map(|_| {
            let height = if n.flip() { -2.0 } else { n.between(-4.0, 4.0) };
            let from = n.vector(3.0).with_y(height);
            ray(
                from,
                n.vector(1.0).with_y(if n.flip() { 0.0 } else { -0.0 }),
            )
        });
        let below = below.collect();
        both(oblique, below, demands)
    },
};

pub(super) const START_ON_PLANE: Case = Case {
    id: "flat/start-on-plane",
    name: "rays that start on a plane",
    sets_up: "Starts that are exactly on it, and any direction.",
    danger: "t = 0 is no hit: code that takes it has the surface shadow itself.",
    demands: &[Exact],
    trial: |n, demands| {
        let oblique = (0..1000).map(|_| ray(level(n), n.vector(1.0))).collect();
        let below = (0..1000).map(|_| ray(n.vector(3.0).with_y(-2.0), n.vector(1.0)));
        let below = below.collect();
        both(oblique, below, demands)
    },
    ..IN_PLANE
};

// The normal is (0, 1, 0): the height is one difference, the slope is exact, t is the quotient.
pub(super) const SLOPE_1E_8: Case = Case {
    id: "flat/slope-1e-8",
    name: "rays that fall by 0.00000001 on their way",
    sets_up: "A level plane below the camera; rays that go down or up by so little.",
    danger: "A threshold for d.n takes them for parallel, though t is known to two roundings.",
    demands: &[Exact, Distance(2.0)],
    fails: &[Textbook],
    trial: |n, demands| {
        let rays = (0..2000).map(|_| {
            let fall = if n.flip() { 1e-8 } else { -1e-8 };
            ray(n.vector(1.0), n.direction().with_y(fall))
        });
        let rays = rays.collect();
        aimed(rounded([LOW]), rays, demands)
    },
    ..IN_PLANE
};

// Height 4 u |n| |p - o|, slope 3 u |n| |d|, and the quotient: all in parts of B.
pub(super) const SLOPE_OBLIQUE: Case = Case {
    id: "flat/slope-oblique",
    name: "rays nearly along an oblique plane",
    sets_up: "d.n is 10^-8 to 10^-4 of |d|, which is from 0.01 to 1.",
    danger: "A threshold for d.n grows with 1/|d|: clear hits are missed.",
    demands: &[Classified, Residual(4.0)],
    trial: |n, demands| {
        let flat = rounded([plane(DVec3::new(-1.0, -3.0, 0.0), OBLIQUE)]);
        let normal = DVec3::from(flat.planes[0].normal);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let fall = 10f64.powf(n.between(-8.0, -4.0));
                let fall = if n.flip() { fall } else { -fall };
                let direction = across(normal, n) + normal * fall;
                ray(n.vector(1.0), direction * 10f64.powf(n.between(-2.0, 0.0)))
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..SLOPE_1E_8
};

pub(super) const EDGE_ON: Case = Case {
    id: "flat/edge-on",
    name: "disks seen edge-on",
    sets_up: "Rays in the plane of a disk, through it and past it, from in it and from afar.",
    danger: "t is 0 / 0, and code that rejects only a distance above r lets NaN through.",
    fails: &[],
    trial: |n, demands| {
        let oblique = disk(DVec3::ZERO, OBLIQUE, 3.0);
        let upright = disk(DVec3::new(0.0, 0.0, -4.0), DVec3::X, 1.0);
        let through = (0..1000).map(|_| {
            let way = level(n);
            ray(way * -(n.pick(4) as f64), way)
        });
        let through = through.collect();
        let past = (0..1000).map(|_| {
            let from = n.vector(6.0).with_x(0.0);
            ray(from, n.vector(1.0).with_x(0.0))
        });
        let past = past.collect();
        Ok(Box::new(Together(vec![
            aimed(rounded([oblique]), through, demands)?,
            aimed(rounded([upright]), past, demands)?,
        ])))
    },
    ..IN_PLANE
};

pub(super) const BEYOND_F32: Case = Case {
    id: "flat/beyond-f32",
    name: "planes that rays meet beyond the largest f32",
    sets_up: "A level plane; rays that fall by 10^-45 to 10^-37 on their way.",
    danger: "h / d.n is infinity, which passes for a hit in front of \"no hit\".",
    demands: &[Finite],
    trial: |n, demands| {
        let rays = (0..2000).map(|_| {
            let fall = 10f64.powf(n.between(-45.0, -37.0));
            ray(n.vector(1.0), n.direction().with_y(-fall))
        });
        let rays = rays.collect();
        aimed(rounded([LOW]), rays, demands)
    },
    ..IN_PLANE
};

/// A level plane 2 below the camera.
const LOW: Geometry = Geometry::Plane {
    point: DVec3::new(0.0, -2.0, 0.0),
    normal: DVec3::Y,
};

/// Exactly in the oblique plane through the camera, of any of some lengths.
fn level(n: &mut Numbers) -> DVec3 {
    let way = LEVEL[n.pick(LEVEL.len())] * 2f64.powi(n.pick(9) as i32 - 6);
    if n.flip() { way } else { -way }
}

/// Rays at the oblique plane through the camera, and rays at the level one below it.
fn both(
    oblique: Vec<Ray<f32>>,
    below: Vec<Ray<f32>>,
    demands: &[Demand],
) -> Result<Box<dyn Trial>> {
    Ok(Box::new(Together(vec![
        aimed(rounded([plane(DVec3::ZERO, OBLIQUE)]), oblique, demands)?,
        aimed(rounded([LOW]), below, demands)?,
    ])))
}

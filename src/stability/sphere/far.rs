//! Spheres that are small for their distance.

use glam::DVec3;

use super::spheres;
use crate::error::Result;
use crate::random::Numbers;
use crate::render::Accuracy::{Robust, Textbook};
use crate::stability::RAYS;
use crate::stability::aim::passing;
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{
    self, Classified, ClassifiedClearly, ClassifiedWithin, Own, Residual,
};
use crate::stability::shapes::{ASIDE, flat_of, scene_of, sphere};
use crate::stability::trials::aimed::aimed;
use crate::stability::trials::seen::Seen;

const RAYS_AT_IT: &str =
    "Rays from the camera, half of them past the centre at 0 to 1.05 radii, half at the rim.";

pub(super) const AT_1E3: Case = Case {
    id: "sphere/far-1e3",
    name: "a unit sphere 1,000 away",
    sets_up: RAYS_AT_IT,
    danger: "b^2 - 4ac subtracts two numbers of 10^6 to learn of one.",
    demands: &[Classified, Residual(4.0)],
    fails: &[Textbook],
    is_random: true,
    trial: |n, demands| far(1e3, 1.0, n, demands),
};

pub(super) const AT_1E4: Case = Case {
    id: "sphere/far-1e4",
    name: "a unit sphere 10,000 away",
    danger: "The rounding of |f|^2, 10^8, is larger than r^2: b^2 - 4ac has no correct digit.",
    trial: |n, demands| far(1e4, 1.0, n, demands),
    ..AT_1E3
};

pub(super) const AT_1E5: Case = Case {
    id: "sphere/far-1e5",
    name: "a unit sphere 100,000 away",
    danger: "b^2 - 4ac is off by hundreds of r^2: hit or miss is as good as drawn.",
    trial: |n, demands| far(1e5, 1.0, n, demands),
    ..AT_1E3
};

pub(super) const AT_1E5_SEEN: Case = Case {
    id: "sphere/far-1e5-seen",
    name: "the points of a unit sphere 100,000 away",
    sets_up: "A picture that the sphere fills.",
    danger: "o + t d is off by the rounding of the distance, so a normal that is taken from it \
             has any length.",
    demands: &[Own(
        "normal and point are within 8 u of the length 1 and of r, up to one rounding of the \
         distance",
    )],
    is_random: false,
    trial: |_, _| seen(1e5),
    ..AT_1E3
};

pub(super) const AT_1E6: Case = Case {
    id: "sphere/far-1e6",
    name: "a unit sphere 1,000,000 away",
    danger: "The sphere is some 16 roundings of its distance wide: f32 errs near the rim, \
             whatever the formula.",
    demands: &[ClassifiedClearly],
    fails: &[Textbook, Robust],
    trial: |n, demands| far(1e6, 1.0, n, demands),
    ..AT_1E3
};

pub(super) const AT_1E7: Case = Case {
    id: "sphere/far-1e7",
    name: "a unit sphere 10,000,000 away",
    danger: "The sphere is smaller than the rounding of its centre: no f32 formula can tell hit \
             from miss. It takes wider numbers, and the program has to say so.",
    trial: |n, demands| far(1e7, 1.0, n, demands),
    ..AT_1E6
};

pub(super) const SMALL: Case = Case {
    id: "sphere/small",
    name: "a sphere of radius 0.001, 10 away",
    danger: "r^2 is 10^-6, less than the rounding of |f|^2 = 100 in f32.",
    trial: |n, demands| far(10.0, 1e-3, n, demands),
    ..AT_1E3
};

// The test errs by 14 u (|f| + r), at most 70 u here, and B is 2e6.
pub(super) const AWAY_FROM_CAMERA: Case = Case {
    id: "sphere/away-from-camera",
    name: "a unit sphere next to the rays, 1,000,000 from the camera",
    sets_up: "Rays that start 2 to 4 from the centre, aimed at the sphere and at its rim.",
    danger: "|o|^2 - 2 o.c + |c|^2, with |c|^2 - r^2 computed beforehand, cancels to nothing \
             where o and c are far; o - c does not.",
    demands: &[ClassifiedWithin(3.5e-5), Residual(4.0)],
    fails: &[],
    trial: away_from_camera,
    ..AT_1E3
};

/// Of a sphere so far away, half the time at its rim, give or take 40 roundings of f32.
pub(super) fn impact(distance: f64, radius: f64, n: &mut Numbers) -> f64 {
    if n.flip() {
        return n.between(0.0, 1.05) * radius;
    }
    let rounding = (distance + radius) * 2f64.powi(-24);
    let least = (radius - 40.0 * rounding).max(0.0);
    n.between(least, radius + 40.0 * rounding)
}

/// Rays at a sphere so far away.
fn far(distance: f64, radius: f64, n: &mut Numbers, demands: &[Demand]) -> Result<Box<dyn Trial>> {
    let flat = spheres([(ASIDE * distance, radius)]);
    let center = DVec3::from(flat.spheres[0].center);
    let rays = (0..RAYS)
        .map(|_| passing(DVec3::ZERO, center, impact(distance, radius, n), n))
        .collect();
    aimed(flat, rays, demands)
}

/// A picture of a unit sphere so far away.
fn seen(distance: f64) -> Result<Box<dyn Trial>> {
    let center = ASIDE * distance;
    let mut scene = scene_of([sphere(center, 1.0)]);
    (scene.image.width, scene.image.height) = (64, 64);
    scene.camera.target = center;
    scene.camera.fov_degrees = (2.0 / distance).to_degrees();
    Ok(Box::new(Seen::new(flat_of(&scene), 8.0)?))
}

fn away_from_camera(n: &mut Numbers, demands: &[Demand]) -> Result<Box<dyn Trial>> {
    let flat = spheres([(ASIDE * 1e6, 1.0)]);
    let center = DVec3::from(flat.spheres[0].center);
    let rays = (0..RAYS / 5)
        .map(|_| {
            let distance = n.between(2.0, 4.0);
            let to_start = n.direction() * distance;
            // The start is rounded before the ray is aimed from it.
            let from = (center + to_start).as_vec3().as_dvec3();
            passing(from, center, impact(distance, 1.0, n), n)
        })
        .collect();
    aimed(flat, rays, demands)
}

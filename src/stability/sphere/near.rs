//! Spheres whose surface is close.

use glam::{DVec3, Vec3};

use super::far::impact;
use super::spheres;
use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::layout::NO_HIT;
use crate::paths::Aim;
use crate::render::Accuracy::Textbook;
use crate::stability::RAYS;
use crate::stability::aim::{across, passing, ray};
use crate::stability::case::Case;
use crate::stability::demand::Demand::{
    Along, Classified, ClassifiedWithin, Distance, Exact, NoSelfHit, Own, Residual,
};
use crate::stability::shapes::{ASIDE, flat_of, scene_of, sphere};
use crate::stability::tally::must;
use crate::stability::trials::aimed::aimed;
use crate::stability::trials::journeys::{Journeys, Path};
use crate::stability::trials::seen::Seen;
use crate::stability::trials::together::Together;

// Within 60 degrees of straight down b is off by 6 u. b^2 - a c, over a and times a, takes 16 u
// and its root 9; q = b + root is off by 8.5 u, c = the power by 1 u, and the quotient by one.
pub(super) const EYE_1_ABOVE: Case = Case {
    id: "sphere/eye-1-above",
    name: "a sphere of radius 1,000,000, the camera 1 above it",
    sets_up: "Rays from the camera at the ground, up to 60 degrees from straight down.",
    danger: "|f|^2 - r^2 is 2 10^6, less than the 12 digits of its terms tell in f32: t has no \
             correct digit.",
    demands: &[Exact, Distance(11.0)],
    fails: &[Textbook],
    is_random: true,
    trial: |n, demands| {
        let flat = spheres([(ASIDE * 1_000_001.0, 1e6)]);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let down = down(&flat);
                let aside = across(down, n) * n.between(0.0, 3f64.sqrt());
                ray(DVec3::ZERO, down + aside)
            })
            .collect();
        aimed(flat, rays, demands)
    },
};

// The b of a ray at the horizon is off by 3 u |f| |d|, which moves the place where it passes by
// 3 u |f| cos, where cos = 6.3e-4 is that of the angle between f and d there. B is 2 |f|.
pub(super) const HORIZON: Case = Case {
    id: "sphere/horizon",
    name: "the horizon of a sphere of radius 10,000,000, the camera 2 above it",
    sets_up: "Rays from the camera that pass the horizon at up to 3 microradians.",
    danger: "From the radius alone f32 knows the ground to within a unit: rays at the horizon \
             miss, and rays over it hit, by milliradians.",
    demands: &[ClassifiedWithin(1e-3)],
    trial: |n, demands| {
        let flat = ground();
        let (down, distance) = (down(&flat), center(&flat).length());
        let horizon = (flat.spheres[0].radius / distance).asin();
        let rays = (0..RAYS / 5)
            .map(|_| {
                let (sine, cosine) = (horizon + n.between(-3e-6, 3e-6)).sin_cos();
                ray(DVec3::ZERO, down * cosine + across(down, n) * sine)
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..EYE_1_ABOVE
};

pub(super) const GROUND_SEEN: Case = Case {
    id: "sphere/ground-seen",
    name: "a picture of the horizon of a sphere of radius 1,000,000",
    sets_up: "The camera 1/8 above it; a picture of 0.03 degrees, half of it ground.",
    danger: "Where the ray meets the ground it passes so close to the rim that r^2 - l.l is \
             negative in f32: its root, and the normal, are NaN.",
    demands: &[Own("normals are within 8 u of the length 1, points of r")],
    fails: &[],
    is_random: false,
    trial: |_, _| {
        let aside = ASIDE.cross(DVec3::Y).normalize();
        let mut scene = scene_of([sphere(ASIDE * 1e6, 1e6 - 0.125)]);
        (scene.image.width, scene.image.height) = (64, 64);
        // The horizon is 0.0005 below the level.
        scene.camera.target = aside + ASIDE * 5e-4;
        scene.camera.up = -ASIDE;
        scene.camera.fov_degrees = 0.03;
        Ok(Box::new(Seen::new(flat_of(&scene), 8.0)?))
    },
};

// As above with 2 u more of b, for f; and the power of the start has errors of 6 u |o| |c| from
// o.c, where |o| = 100, and of its two sums: 340 u in parts of 2 h r.
pub(super) const GROUND_WALK: Case = Case {
    id: "sphere/ground-walk",
    name: "rays that start 1 above that ground, 100 from the camera",
    sets_up: "The ground below the camera; the rays up to 60 degrees from straight down.",
    danger: "The camera's own height is known from f64, that of a ray elsewhere is not: \
             |o - c|^2 - r^2 starts anew from nothing.",
    demands: &[Exact, Distance(360.0)],
    trial: |n, demands| {
        let flat = ground();
        let (center, radius) = (center(&flat), flat.spheres[0].radius);
        let down = down(&flat);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let over = across(down, n) * 100.0;
                let up = (over - center).normalize();
                let from = center + up * (radius + 1.0);
                let aside = across(up, n) * n.between(0.0, 3f64.sqrt());
                ray(from, aside - up)
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..EYE_1_ABOVE
};

// The power of the start is off by 6 u |f|^2 and 2 u r^2 and is divided by q, which is above 1:
// below 8 u, and a few of t; B is 17.
pub(super) const START_JUST_ABOVE: Case = Case {
    id: "sphere/start-just-above",
    name: "rays that start 0.00001 above a unit sphere",
    sets_up: "The camera elsewhere; rays up to 60 degrees from straight down.",
    danger: "A smallest t of 10^-3 takes the far side in place of the near one.",
    demands: &[Exact, Along(1.0)],
    fails: &[],
    trial: |n, demands| {
        let flat = spheres([(ASIDE * 8.0, 1.0)]);
        let center = center(&flat);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let up = n.direction();
                let aside = across(up, n) * n.between(0.0, 3f64.sqrt());
                ray(center + up * (1.0 + 1e-5), aside - up)
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..EYE_1_ABOVE
};

pub(super) const SEEN_FROM_FAR: Case = Case {
    id: "sphere/seen-from-far",
    name: "a unit sphere 0.01 below the camera, and rays from 10,000 away",
    sets_up: "Rays from all around, half of them past the centre at 0 to 1.05 radii, half at the \
              rim.",
    danger: "The formulas for a camera near the ground are b^2 - a c again, which is right only \
             for rays that start there.",
    demands: &[Classified, Residual(4.0)],
    trial: |n, demands| {
        let flat = spheres([(ASIDE * 1.01, 1.0)]);
        let center = center(&flat);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let from = center + n.direction() * 10f64.powf(n.between(0.5, 4.0));
                let from = from.as_vec3().as_dvec3();
                let distance = from.distance(center);
                passing(from, center, impact(distance, 1.0, n), n)
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..EYE_1_ABOVE
};

pub(super) const LEAVING: Case = Case {
    id: "sphere/leaving-1e-6",
    name: "a sphere of radius 0.000001 that rays leave",
    sets_up: "Rays from 8 radii away that go on from where they hit, in any direction.",
    danger: "A fixed offset of 10^-3 is a thousand radii, and a smallest t of 10^-3 skips the \
             sphere.",
    demands: &[
        NoSelfHit,
        Own("rays start within 10^-4 radii of the surface, on the side to which they go"),
    ],
    trial: |n, _| {
        let radius = 1e-6;
        let flat = spheres([(ASIDE * (8.0 * radius), radius)]);
        let center = center(&flat);
        let rays: Vec<Ray<f32>> = (0..RAYS / 5)
            .map(|_| passing(DVec3::ZERO, center, n.between(0.0, 0.95) * radius, n))
            .collect();
        let onward = rays.iter().map(|_| n.direction().as_vec3().to_array());
        let aims: Vec<Aim> = onward.map(|onward| Aim::Towards(onward.into())).collect();
        let widths = || Widths::of(flat.clone(), Bounds::None);
        let next_to_it = Journeys {
            widths: widths(),
            rays: rays.clone(),
            aims: aims.clone(),
            legs: 1,
            judge: Box::new(move |path: &Path<'_>| {
                let [start, onward] = [path.end.origin, path.end.direction]
                    .map(|v| Vec3::from_array(v.into()).as_dvec3());
                let height = start.distance(center) - radius;
                let is_out = onward.dot(start - center) > 0.0;
                if is_out != (height > 0.0) {
                    return (f64::INFINITY, 1e-4);
                }
                (height.abs() / radius, 1e-4)
            }),
        };
        // From outside nothing is met, from within the far side.
        let not_again = Journeys {
            widths: widths(),
            rays,
            aims,
            legs: 2,
            judge: Box::new(move |path: &Path<'_>| {
                let onward = Vec3::from_array(path.end.direction.into()).as_dvec3();
                let again = path.found[1];
                must(again.id == NO_HIT || again.t * onward.length() > 1e-3 * radius)
            }),
        };
        Ok(Box::new(Together(vec![
            Box::new(next_to_it),
            Box::new(not_again),
        ])))
    },
    ..EYE_1_ABOVE
};

/// A sphere of radius 9,999,998 with the camera 2 above it, all numbers exact.
fn ground() -> Flat<f64> {
    spheres([(ASIDE * 1e7, 9_999_998.0)])
}

fn center(flat: &Flat<f64>) -> DVec3 {
    flat.spheres[0].center.into()
}

fn down(flat: &Flat<f64>) -> DVec3 {
    center(flat).normalize()
}

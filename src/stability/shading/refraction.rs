//! Rays that are bent.

use glam::DVec3;

use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::kernel::camera::Ray;
use crate::paths::Aim;
use crate::random::Numbers;
use crate::stability::aim::{ray, step};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{Finite, Own};
use crate::stability::journeys::{Journeys, Path};
use crate::stability::shapes::{disk, flat_of, scene_of};
use crate::tier::Accuracy::Textbook;

const UNIT: &str = "what goes on is of length 1, to 4 u";

pub(super) const CASES: &[Case] = &[
    Case {
        id: "shading/critical-angle",
        name: "the critical angle, to the last bits",
        sets_up: "Rays upon a disk, refracted by 1.1, 1.5, 2 and 1e10, at the angle from which on \
                  all is thrown back, and some ulp beside it.",
        danger: "The square of a cosine falls below 0 by a rounding, and its root is no number.",
        demands: &[Finite, Own(UNIT)],
        fails: &[],
        is_random: false,
        trial: |_, _| critical_angle(),
    },
    Case {
        id: "shading/straight-on",
        name: "a ray along the normal",
        sets_up: "Rays upon tilted disks along their normals, of lengths from 1e-15 to 1e15, \
                  refracted.",
        danger: "The cosine comes out as 1 and a bit: its arc, or the root of 1 less its square, \
                 is no number. And a short direction is taken for one along the disk.",
        demands: &[Finite, Own(UNIT)],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| straight_on(n),
    },
];

/// Three squares, their sum, a root and a quotient: (3 + 1) / 2 + 1 + 1 roundings.
const LENGTH: f64 = 4.0 / 16_777_216.0;

fn is_of_length_one(path: &Path<'_>) -> (f64, f64) {
    let direction = glam::Vec3::from_array(path.end.direction.into());
    ((direction.as_dvec3().length() - 1.0).abs(), LENGTH)
}

fn refracted(disk_normal: DVec3, rays: Vec<Ray<f32>>, ratios: &[f32]) -> Journeys {
    let mirror = disk(disk_normal * -2.0, disk_normal, 1e3);
    let aims = rays.iter().zip(ratios.iter().cycle());
    Journeys {
        widths: Widths::of(flat_of(&scene_of([mirror])), Bounds::None),
        aims: aims
            .map(|(_, ratio)| Aim::Refracted { ratio: *ratio })
            .collect(),
        rays,
        legs: 1,
        judge: Box::new(is_of_length_one),
    }
}

fn critical_angle() -> Result<Box<dyn Trial>> {
    let ratios = [1.1f32, 1.5, 2.0, 1e10];
    let mut rays = Vec::new();
    for ulps in -8..=8 {
        for ratio in ratios {
            let sine = f64::from(1.0 / ratio);
            let cosine = step((1.0 - sine * sine).sqrt(), ulps);
            rays.push(ray(DVec3::ZERO, DVec3::new(sine, 0.0, -cosine)));
        }
    }
    Ok(Box::new(refracted(DVec3::Z, rays, &ratios)))
}

fn straight_on(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let trials = (0..20).map(|_| {
        let normal = n.direction();
        let lengths = (0..50).map(|_| 10f64.powf(n.between(-15.0, 15.0)));
        let rays = lengths
            .map(|length| ray(DVec3::ZERO, -normal * length))
            .collect();
        let trial: Box<dyn Trial> = Box::new(refracted(normal, rays, &[0.25, 1.0, 1.5, 4.0]));
        trial
    });
    Ok(Box::new(crate::stability::together::Together(
        trials.collect(),
    )))
}

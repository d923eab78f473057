//! Rays that are bent.

use glam::DVec3;

use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::kernel::camera::Ray;
use crate::kernel::vector::Vec3;
use crate::paths::Aim;
use crate::random::Numbers;
use crate::stability::aim::{ray, step};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{Finite, Own};
use crate::stability::shapes::{disk, flat_of, scene_of};
use crate::stability::trials::journeys::{Journeys, Path};
use crate::stability::trials::together::Together;
use crate::tier::Accuracy::Textbook;

const UNIT: &str = "what goes on is of length 1, to 4 u";

pub(super) const CASES: &[Case] = &[
    Case {
        id: "shading/critical-angle",
        name: "the critical angle, to the last bits",
        sets_up: "Rays upon a disk, refracted by 1.1, 1.5, 2 and 1000, at the angle from which on \
                  all is thrown back, some ulp beside it, and a thousandth.",
        danger: "The square of a cosine falls below 0 by a rounding, and its root is no number.",
        demands: &[
            Finite,
            Own(UNIT),
            Own("beside the angle, it goes through or back as it should"),
        ],
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

/// By how much the square of the sine beyond may be off 1 before light must go through, or
/// back: twice what a unit vector, its part across and its square, and two products take.
const UNDECIDED: f64 = 32.0 / 16_777_216.0;

/// The length of what goes on, and on which side of the normal it does.
fn judge(path: &Path<'_>, normal: DVec3, ratio: f64) -> (f64, f64) {
    let vector = |v: Vec3<f32>| glam::Vec3::from_array(v.into()).as_dvec3();
    let [came, goes] = [path.ray.direction, path.end.direction].map(vector);
    let across = came.normalize().cross(normal).length();
    let beyond = (ratio * across).powi(2);
    let is_thrown_back = goes.dot(normal) > 0.0;
    if (beyond - 1.0).abs() > UNDECIDED && is_thrown_back != (beyond > 1.0) {
        return (1.0, 0.0);
    }
    ((goes.length() - 1.0).abs(), LENGTH)
}

/// Rays upon a disk whose normal faces them.
fn refracted(normal: DVec3, rays: Vec<Ray<f32>>, ratio: f32) -> Box<dyn Trial> {
    let flat = flat_of(&scene_of([disk(normal * -2.0, normal, 1e4)]));
    Box::new(Journeys {
        widths: Widths::of(flat, Bounds::None),
        aims: vec![Aim::Refracted { ratio }; rays.len()],
        rays,
        legs: 1,
        judge: Box::new(move |path: &Path<'_>| judge(path, normal, ratio.into())),
    })
}

fn critical_angle() -> Result<Box<dyn Trial>> {
    let trials = [1.1f32, 1.5, 2.0, 1000.0].map(|ratio| {
        let sine = f64::from(1.0 / ratio);
        let at = |sine: f64| DVec3::new(sine, 0.0, -(1.0 - sine * sine).sqrt());
        let beside = [0.999, 1.001].map(|part| ray(DVec3::ZERO, at(sine * part)));
        let to_the_ulp = (-8..=8).map(|ulps| {
            let direction = at(sine);
            ray(DVec3::ZERO, direction.with_x(step(direction.x, ulps)))
        });
        let rays = beside.into_iter().chain(to_the_ulp).collect();
        refracted(DVec3::Z, rays, ratio)
    });
    Ok(Box::new(Together(trials.into())))
}

fn straight_on(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let mut trials = Vec::new();
    for _ in 0..5 {
        let normal = n.direction();
        for ratio in [0.25, 1.0, 1.5, 4.0] {
            let lengths = (0..50).map(|_| 10f64.powf(n.between(-15.0, 15.0)));
            let rays = lengths.map(|length| ray(DVec3::ZERO, -normal * length));
            trials.push(refracted(normal, rays.collect(), ratio));
        }
    }
    Ok(Box::new(Together(trials)))
}

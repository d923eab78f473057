//! Numbers that are very small or very large.

use glam::DVec3;

use super::spheres;
use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::kernel::camera::Ray;
use crate::random::Numbers;
use crate::render::Accuracy::Textbook;
use crate::scene::Scene;
use crate::stability::RAYS;
use crate::stability::aim::{passing, ray};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, Classified, Finite, Refused, Residual, Same};
use crate::stability::shapes::{ASIDE, plane, scene_of, sphere};
use crate::stability::trials::aimed::aimed;
use crate::stability::trials::alike::Alike;
use crate::stability::trials::refused;

pub(super) const DIRECTION_1E10: Case = Case {
    id: "sphere/direction-1e10",
    name: "directions that are 10^10 or 10^-10 long",
    sets_up: "Rays from 2 radii away that pass the centre at 0 to 0.9 radii.",
    danger: "Directions are taken for unit length: t is off by their length.",
    demands: &[Classified, Residual(4.0)],
    fails: &[],
    is_random: true,
    trial: |n, demands| long(n, demands, |n| if n.flip() { 1e10 } else { 1e-10 }),
};

pub(super) const DIRECTION_POWERS: Case = Case {
    id: "sphere/direction-powers",
    name: "the same rays with directions 2^33 times as long, or as short",
    sets_up: "Each ray twice; the scale is a power of two, so no rounding changes.",
    danger: "A threshold for t, or for the discriminant, has a scale.",
    demands: &[Same(0.0)],
    trial: |n, _| {
        let flat = || spheres([(ASIDE * 2.0, 1.0)]);
        let center = DVec3::from(flat().spheres[0].center);
        let ordinary: Vec<Ray<f32>> = (0..RAYS / 5)
            .map(|_| passing(DVec3::ZERO, center, n.between(0.0, 1.1), n))
            .collect();
        let scale: Vec<f64> = ordinary
            .iter()
            .map(|_| 2f64.powi(if n.flip() { 33 } else { -33 }))
            .collect();
        let scaled = ordinary.iter().zip(&scale).map(|(ray, scale)| Ray {
            direction: ray.direction * (1.0 / scale) as f32,
            ..*ray
        });
        let scaled = scaled.collect();
        Ok(Box::new(Alike {
            left: (Widths::of(flat(), Bounds::None), ordinary),
            right: (Widths::of(flat(), Bounds::None), scaled),
            scale,
            roundings: 0.0,
        }))
    },
    ..DIRECTION_1E10
};

pub(super) const DIRECTION_LONG: Case = Case {
    id: "sphere/direction-1e30",
    name: "directions that are 10^30 long",
    danger: "d.d is beyond f32, and infinity less infinity is no number.",
    fails: &[Textbook],
    trial: |n, demands| long(n, demands, |_| 1e30),
    ..DIRECTION_1E10
};

pub(super) const DIRECTION_SHORT: Case = Case {
    id: "sphere/direction-1e-30",
    name: "directions that are 10^-30 long",
    danger: "d.d is below the least f32, and a quotient by it infinite.",
    fails: &[Textbook],
    trial: |n, demands| long(n, demands, |_| 1e-30),
    ..DIRECTION_1E10
};

pub(super) const SMALLEST: Case = Case {
    id: "sphere/smallest",
    name: "a sphere of the least radius, 10^-15",
    sets_up: "Rays from 3 to 10 radii away that pass the centre at 0 to 1.05 radii.",
    danger: "Any absolute epsilon is larger than the scene; r^2 is near the least f32.",
    demands: &[Classified, Residual(4.0)],
    trial: |n, demands| at_scale(1e-15, n, demands),
    ..DIRECTION_1E10
};

pub(super) const LARGEST: Case = Case {
    id: "sphere/largest",
    name: "a sphere at the largest coordinates, 10^15",
    danger: "Where 10^10 stands for infinity, the scene is beyond it; squares are 10^30, and one \
             more product overflows in f32.",
    trial: |n, demands| at_scale(3e12, n, demands),
    ..SMALLEST
};

pub(super) const ORIGIN_1E20: Case = Case {
    id: "sphere/origin-1e20",
    name: "rays that start 10^20 away",
    sets_up: "Rays at a unit sphere near the camera, along axes and in between, and away from it.",
    danger: "|f|^2 overflows in f32: t0 is infinity, or infinity over infinity.",
    demands: &[Finite],
    trial: |n, demands| {
        let rays = (0..2000)
            .map(|index| {
                let axis = match index % 4 {
                    0 => DVec3::Z,
                    1 => DVec3::new(1.0, 0.0, -1.0),
                    _ => n.direction(),
                };
                let to = if n.flip() { -axis } else { axis };
                ray(axis * 1e20, to * n.between(0.5, 2.0))
            })
            .collect();
        aimed(spheres([(DVec3::NEG_Z * 4.0, 1.0)]), rays, demands)
    },
    ..DIRECTION_1E10
};

pub(super) const CENTER_1E20: Case = Case {
    id: "sphere/center-1e20",
    name: "coordinates of 10^20",
    sets_up: "Scenes with such a centre, radius or camera, and one with a centre that is no \
              number.",
    danger: "Squares overflow in f32 from 1.8 10^19 on: pictures of NaN, without a word.",
    demands: &[Refused],
    is_random: false,
    trial: |_, _| {
        let mut far_camera = scene_of([sphere(DVec3::ZERO, 1.0)]);
        far_camera.camera.eye = DVec3::X * 1e20;
        refuse([
            (scene_of([sphere(DVec3::X * 1e20, 1.0)]), "beyond 1e15"),
            (scene_of([sphere(DVec3::ZERO, 1e20)]), "beyond 1e15"),
            (scene_of([plane(DVec3::Y * 1e20, DVec3::Y)]), "beyond 1e15"),
            (scene_of([sphere(DVec3::splat(f64::NAN), 1.0)]), "finite"),
            (far_camera, "beyond 1e15"),
        ])
    },
    ..DIRECTION_1E10
};

pub(super) const RADIUS_REFUSED: Case = Case {
    id: "sphere/radius-refused",
    name: "radii of 0, below it, too small, and no number",
    sets_up: "Scenes with such a sphere.",
    danger: "r^2 forgets the sign, and no comparison with NaN holds: each renders as something.",
    trial: |_, _| {
        let of = |radius: f64| scene_of([sphere(DVec3::NEG_Z * 3.0, radius)]);
        refuse([
            (of(0.0), "greater than 0"),
            (of(-0.0), "greater than 0"),
            (of(-1.0), "greater than 0"),
            (of(1e-20), "below 1e-15"),
            (of(f64::NAN), "finite"),
            (of(f64::INFINITY), "finite"),
        ])
    },
    ..CENTER_1E20
};

fn refuse<const N: usize>(scenes: [(Scene, &'static str); N]) -> Result<Box<dyn Trial>> {
    Ok(Box::new(refused::Refused(scenes.into())))
}

/// Rays at a sphere next to the camera, of directions so long.
fn long(
    n: &mut Numbers,
    demands: &[Demand],
    length: fn(&mut Numbers) -> f64,
) -> Result<Box<dyn Trial>> {
    let flat = spheres([(ASIDE * 2.0, 1.0)]);
    let center = DVec3::from(flat.spheres[0].center);
    let rays = (0..RAYS / 5)
        .map(|_| {
            let unit = passing(DVec3::ZERO, center, n.between(0.0, 0.9), n);
            let direction = unit.direction * length(n) as f32;
            Ray { direction, ..unit }
        })
        .collect();
    aimed(flat, rays, demands)
}

/// Rays from all around at a sphere of such a radius, from up to 10 of it away.
fn at_scale(radius: f64, n: &mut Numbers, demands: &[Demand]) -> Result<Box<dyn Trial>> {
    let flat = spheres([(ASIDE * (300.0 * radius), radius)]);
    let center = DVec3::from(flat.spheres[0].center);
    let rays = (0..RAYS / 5)
        .map(|_| {
            let distance = n.between(3.0, 10.0);
            let from = (center + n.direction() * (distance * radius))
                .as_vec3()
                .as_dvec3();
            passing(from, center, n.between(0.0, 1.05) * radius, n)
        })
        .collect();
    aimed(flat, rays, demands)
}

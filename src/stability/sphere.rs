//! Spheres: far, near, large, small, touched.

use glam::DVec3;

use super::RAYS;
use super::aim::passing;
use super::aimed::Aimed;
use super::case::{Case, Family, Trial};
use super::demand::Demand::{self, Classified, ClassifiedClearly, Residual};
use super::shapes::{flat_of, scene_of, sphere};
use crate::bounds::Bounds;
use crate::error::Result;
use crate::random::Numbers;
use crate::render::Accuracy::{Robust, Textbook};

/// Spheres.
pub const FAMILY: Family = Family {
    name: "sphere",
    about: "Spheres: far, near, large, small, touched.",
    cases: &[&[
        Case {
            id: "sphere/far-1e3",
            name: "a unit sphere 1,000 away",
            sets_up: "Rays from the camera that pass the centre at 0 to 1.05 radii.",
            danger: "b^2 - 4ac subtracts two numbers of 10^6 to learn of one.",
            demands: &[Classified, Residual(4.0)],
            fails: &[Textbook],
            is_random: true,
            trial: |n, demands| far(1e3, n, demands),
        },
        Case {
            id: "sphere/far-1e7",
            name: "a unit sphere 10,000,000 away",
            sets_up: "As before; the sphere is smaller than the rounding of its centre.",
            danger: "No f32 formula can tell hit from miss: it takes wider numbers, and the \
                     program has to say so.",
            demands: &[ClassifiedClearly],
            fails: &[Textbook, Robust],
            is_random: true,
            trial: |n, demands| far(1e7, n, demands),
        },
    ]],
};

/// Along no axis.
const ASIDE: DVec3 = DVec3::new(0.36, 0.48, -0.8);

/// Rays at a unit sphere so far away.
fn far(distance: f64, n: &mut Numbers, demands: &[Demand]) -> Result<Box<dyn Trial>> {
    let scene = scene_of([sphere(ASIDE * distance, 1.0)]);
    let flat = flat_of(&scene);
    let center = DVec3::from(flat.spheres[0].center);
    let rays = (0..RAYS)
        .map(|_| {
            let impact = n.between(0.0, 1.05);
            passing(DVec3::ZERO, center, impact, n)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::None, rays, demands)?))
}

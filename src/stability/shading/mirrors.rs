//! Rays that are thrown to and fro.

use glam::DVec3;

use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::kernel::camera::Ray;
use crate::layout::NO_HIT;
use crate::paths::Aim;
use crate::random::Numbers;
use crate::stability::aim::ray;
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::Own;
use crate::stability::shapes::{disk, flat_of, scene_of};
use crate::stability::tally::must;
use crate::stability::trials::journeys::{Journeys, Path};
use crate::tier::Accuracy::Textbook;

pub(super) const CASES: &[Case] = &[
    Case {
        id: "shading/facing-mirrors",
        name: "two mirrors a thousandth apart",
        sets_up: "Rays between two facing disks, 1e-3 apart, for 1000 bounces.",
        danger: "An offset of the gap's size puts the ray beyond the other mirror; one too small \
                 has it meet the same one again.",
        demands: &[Own("each bounce is on the other mirror, and none escapes")],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| facing_mirrors(n),
    },
    Case {
        id: "shading/corner",
        name: "three mirrors in a corner",
        sets_up: "Rays into a small tilted corner of three mirrors at right angles.",
        danger: "A ray that starts too far from a mirror misses the next; a normal that is not \
                 of length 1 turns what it throws back.",
        demands: &[Own("the ray goes back where it came from, to 8 u a bounce")],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| corner(n),
    },
];

const BOUNCES: u32 = 1000;

/// Across the gap at up to 0.4 of its width along for each bounce: 1000 of them stay within
/// the disks, whose radius is 0.5.
fn facing_mirrors(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let gap = 1e-3;
    let center = -DVec3::Z;
    let mirrors = [0.0, gap].map(|behind| disk(center - DVec3::Z * behind, DVec3::Z, 0.5));
    let rays: Vec<Ray<f32>> = (0..100)
        .map(|_| {
            let mut aside = || n.between(-0.28, 0.28);
            let direction = DVec3::new(aside(), aside(), 1.0);
            ray(center - DVec3::Z * (0.5 * gap), direction)
        })
        .collect();
    Ok(Box::new(Journeys {
        widths: Widths::of(flat_of(&scene_of(mirrors)), Bounds::None),
        aims: vec![Aim::Mirrored; rays.len()],
        rays,
        legs: BOUNCES,
        judge: Box::new(|path: &Path<'_>| {
            let is_between = path.found.iter().all(|found| found.id != NO_HIT);
            let alternates = path.found.windows(2).all(|pair| pair[0].id != pair[1].id);
            must(is_between && alternates)
        }),
    }))
}

/// What a bounce turns a direction by at most: a normal's three components are rounded, which
/// counts twice, and so does the product with it, and there is a difference.
const TURN: f64 = 8.0 / 16_777_216.0;

/// A corner a hundred-thousandth large: a ray that meets all three mirrors returns.
fn corner(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let size = 1e-5;
    let axes = [
        DVec3::new(0.36, 0.48, 0.8),
        DVec3::new(0.48, 0.64, -0.6),
        DVec3::new(0.8, -0.6, 0.0),
    ];
    let apex = DVec3::new(0.1, 0.2, -0.7) * size;
    let flat = flat_of(&scene_of(axes.map(|axis| disk(apex, axis, 20.0 * size))));
    let mut rays = Vec::new();
    for _ in 0..2000 {
        let mut inside = || {
            axes.iter()
                .fold(DVec3::ZERO, |sum, axis| sum + *axis * n.between(0.2, 1.0))
        };
        // From a point within towards the apex and past it, on each mirror once.
        let (from, direction) = (inside() * size, -inside());
        rays.push(ray(apex + from, direction));
    }
    Ok(Box::new(Journeys {
        widths: Widths::of(flat, Bounds::None),
        aims: vec![Aim::Mirrored; rays.len()],
        rays,
        legs: 3,
        judge: Box::new(|path: &Path<'_>| {
            if path.found.iter().any(|found| found.id == NO_HIT) {
                return (1.0, 0.0);
            }
            let [came, goes] = [path.ray.direction, path.end.direction]
                .map(|v| glam::Vec3::from_array(v.into()).as_dvec3());
            ((came + goes).length() / came.length(), 3.0 * TURN)
        }),
    }))
}

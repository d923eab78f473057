//! Rays that start on a sphere, in it, or with it behind them.

use glam::DVec3;

use super::spheres;
use crate::error::Result;
use crate::random::Numbers;
use crate::stability::RAYS;
use crate::stability::aim::{across, ray};
use crate::stability::axes::frame;
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, Along, Distance, Exact, Finite};
use crate::stability::shapes::ASIDE;
use crate::stability::trials::aimed::aimed;
use crate::stability::trials::together::Together;

/// Where the sphere stands that integer rays start from, of radius 15.
const CENTER: DVec3 = DVec3::new(5.0, 10.0, -10.0);

pub(super) const OUTWARD: Case = Case {
    id: "sphere/start-outward",
    name: "rays that start on a sphere and leave it",
    sets_up: "Starts that are exactly on it, among them the camera; some rays are tangents.",
    danger: "t = 0 is a root: code that takes it, or a rounding of it, has the surface shadow \
             itself.",
    demands: &[Exact],
    fails: &[],
    is_random: true,
    trial: |n, demands| from_surface(n, demands, 1.0),
};

// At least 6 degrees from the tangent plane, so that the root is above r / 10: an error of 16 u
// r^2 of the discriminant is one of 80 u r of the root, and B is above 8 r.
pub(super) const INWARD: Case = Case {
    id: "sphere/start-inward",
    name: "rays that start on a sphere and enter it",
    sets_up: "The same starts, into the sphere.",
    danger: "The near root, 0, is not a hit, and the far one is.",
    demands: &[Exact, Finite, Along(10.0)],
    trial: |n, demands| from_surface(n, demands, -1.0),
    ..OUTWARD
};

// t = r^2 / root(a r^2): r^2 takes 1 u over and 1/2 u under, a 3 u and the product 1 u under the
// root, the root and the quotient 1 u each; together below 5 u.
pub(super) const CENTER_OF_IT: Case = Case {
    id: "sphere/start-center",
    name: "rays that start at the centre of a sphere",
    sets_up: "t is the radius over the length of the direction.",
    danger: "b is 0 and -0: a root that is divided by b, or multiplied by its sign, is lost.",
    demands: &[Exact, Distance(5.0)],
    trial: |n, demands| {
        let flat = spheres([(ASIDE * 7.0, 1.7)]);
        let from = DVec3::from(flat.spheres[0].center);
        let rays = (0..2000)
            .map(|_| ray(from, n.direction() * n.between(0.1, 10.0)))
            .collect();
        aimed(flat, rays, demands)
    },
    ..OUTWARD
};

pub(super) const ABREAST: Case = Case {
    id: "sphere/start-abreast",
    name: "rays that start inside, square to the way to the centre",
    sets_up: "Integers, so that f.d is exactly 0: both roots are of one size.",
    danger: "sign(b) is 0 in WGSL: q = b + sign(b) root is 0, and so are both roots.",
    demands: &[Exact, Distance(6.0)],
    trial: |n, demands| {
        let rays = (0..2000)
            .map(|_| {
                let ([along, left, up], _) = frame(n);
                let aside = (n.pick(7) as f64 - 3.0, n.pick(7) as f64 - 3.0);
                let scale = 2f64.powi(n.pick(9) as i32 - 4);
                ray(CENTER + left * aside.0 + up * aside.1, along * scale)
            })
            .collect();
        aimed(spheres([(CENTER, 15.0)]), rays, demands)
    },
    ..OUTWARD
};

pub(super) const BEHIND: Case = Case {
    id: "sphere/behind",
    name: "spheres behind the start",
    sets_up: "Rays away from the sphere, the nearest of them from 0.01 radii above it.",
    danger: "Both roots are below 0, and squares do not tell.",
    demands: &[Exact],
    trial: |n, demands| {
        let flat = spheres([(ASIDE * 20.0, 1.0)]);
        let center = DVec3::from(flat.spheres[0].center);
        let rays = (0..RAYS / 5)
            .map(|_| {
                let up = n.direction();
                let from = center + up * (1.01 + 10f64.powf(n.between(-3.0, 3.0)));
                ray(from, up + across(up, n) * n.between(0.0, 20.0))
            })
            .collect();
        aimed(flat, rays, demands)
    },
    ..OUTWARD
};

/// Rays that start on the sphere of radius 15, to one side of it: from a sphere elsewhere, then
/// from one that the camera is on.
fn from_surface(n: &mut Numbers, demands: &[Demand], side: f64) -> Result<Box<dyn Trial>> {
    let start = |n: &mut Numbers, is_camera: bool| {
        if is_camera {
            return (CENTER * -1.0, DVec3::new(2.0, 1.0, 2.0));
        }
        let ([axis, tangent, _], length) = frame(n);
        (axis * (15.0 / length), tangent)
    };
    let mut trials = Vec::new();
    for is_camera in [false, true] {
        let center = if is_camera { CENTER } else { CENTER * 4.0 };
        let rays = (0..2000)
            .map(|index| {
                let (up, tangent) = start(n, is_camera);
                if side > 0.0 && index % 10 == 0 {
                    return ray(center + up, tangent * 2f64.powi(n.pick(5) as i32));
                }
                let slope = n.between(0.1, 1.0);
                let level = across(up, n) * (1.0 - slope * slope).sqrt();
                ray(center + up, level + up * (slope * side / 15.0))
            })
            .collect();
        trials.push(aimed(spheres([(center, 15.0)]), rays, demands)?);
    }
    Ok(Box::new(Together(trials)))
}

//! Light, and what keeps it off.

use glam::{DMat3, DVec3};

use super::leaving::point_of;
use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::kernel::camera::Ray;
use crate::layout::NO_HIT;
use crate::oracle::Oracle;
use crate::paths::Aim;
use crate::random::Numbers;
use crate::scene::mesh::{Builtin, build};
use crate::scene::{Falloff, Geometry, Light, PixelSampling, Scene};
use crate::stability::aim::{across, ray_to};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{Finite, Own};
use crate::stability::shapes::{disk, flat_of, mesh, plane, scene_of, sphere};
use crate::stability::tally::must;
use crate::stability::trials::journeys::{Journeys, Path};
use crate::stability::trials::lit::Dark;
use crate::stability::trials::together::Together;
use crate::tier::Accuracy::Textbook;

const DARK: &str = "no light at all";

pub(super) const CASES: &[Case] = &[
    Case {
        id: "shading/light-on-surface",
        name: "a light on the surface that it lights",
        sets_up: "A lamp that weakens with the square of the distance, on a disk, at a pixel's \
                  very point.",
        danger: "The way to it is zero: 0 / 0 is no number, and 1 / 0 is too much.",
        demands: &[Finite, Own(DARK)],
        fails: &[],
        is_random: false,
        trial: |_, _| {
            let shapes = [disk(DVec3::Z * -2.0, DVec3::Z, 1.0)];
            dark(shapes.into(), vec![lamp(DVec3::Z * -2.0)])
        },
    },
    Case {
        id: "shading/light-behind",
        name: "lights behind what is seen, or in its plane",
        sets_up: "Lamps behind a disk and in its plane, within a sphere, and from infinitely far \
                  along the disk and from behind.",
        danger: "A cosine below 0 that is not cut takes light away, or adds it if its sign is \
                 dropped.",
        demands: &[Own(DARK)],
        fails: &[],
        is_random: false,
        trial: |_, _| behind(),
    },
    Case {
        id: "shading/far-lamp",
        name: "a lamp 10,000,000 away, with a surface of its own",
        sets_up: "From a floor, rays to points of a sphere 1e7 away: the way to the lamp ends at \
                  its surface.",
        danger: "The lamp's own surface is met a rounding before the way ends, and casts a \
                 shadow of itself.",
        demands: &[Own("nothing is met before 48 u short of the lamp")],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| far_lamp(n),
    },
    Case {
        id: "shading/contact",
        name: "the contact shadow under a sphere",
        sets_up: "Spheres with radii from 1e-4 to 1e4 that stand on a floor; straight up from the \
                  floor, from the contact point to two radii beside it.",
        danger: "A start too high is above the sphere: light under it, just where it stands.",
        demands: &[Own("dark within the radius, lit beyond")],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| contact(n),
    },
    Case {
        id: "shading/terminator",
        name: "the terminator of a coarse mesh",
        sets_up: "A closed mesh of 320 triangles, a thousandth large, on the side away from the \
                  light: the ray towards it goes through the mesh.",
        danger: "An offset that lifts rays over the next edges hides that triangles are flat, and \
                 lets light through what is thin.",
        demands: &[Own("the ray meets the mesh from within")],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| terminator(n),
    },
];

fn lamp(position: DVec3) -> Light {
    Light::Point {
        position,
        color: [1.0; 3],
        falloff: Falloff::InverseSquare,
        shadow: false,
    }
}

/// A small picture that must be dark; the middle pixel's ray runs along the axis.
fn dark(shapes: Vec<Geometry>, lights: Vec<Light>) -> Result<Box<dyn Trial>> {
    let mut scene = Scene {
        ambient: [0.0; 3],
        lights,
        ..scene_of(shapes)
    }
    .with_size(16, 16);
    scene.camera.sampling = PixelSampling::Corner;
    scene.camera.fov_degrees = 20.0;
    Ok(Box::new(Dark(Widths::of(flat_of(&scene), Bounds::Tree))))
}

fn behind() -> Result<Box<dyn Trial>> {
    let wall = || vec![disk(DVec3::Z * -2.0, DVec3::Z, 1.0)];
    let parallel = |direction| Light::Directional {
        direction,
        color: [1.0; 3],
        shadow: false,
    };
    let point = |position: [f64; 3]| Light::Point {
        position: position.into(),
        color: [1.0; 3],
        falloff: Falloff::None,
        shadow: false,
    };
    let trials = vec![
        dark(
            wall(),
            vec![point([0.5, 0.25, -3.0]), lamp(DVec3::Z * -2.25)],
        )?,
        dark(
            wall(),
            vec![point([4.0, 1.0, -2.0]), lamp(DVec3::new(0.125, 0.0, -2.0))],
        )?,
        dark(
            wall(),
            vec![parallel(-DVec3::Z), parallel(DVec3::X), parallel(-DVec3::Y)],
        )?,
        dark(
            vec![plane(DVec3::Z * -2.0, DVec3::Z)],
            vec![lamp(DVec3::Z * -2.25)],
        )?,
        dark(
            vec![sphere(DVec3::Z * -5.0, 2.0)],
            vec![lamp(DVec3::Z * -5.0), point([0.5, 0.5, -5.5])],
        )?,
    ];
    Ok(Box::new(Together(trials)))
}

/// How far the lamp is, in its radii.
const FAR: f64 = 1e7;

/// By how much, in parts of the way, the lamp's surface may be met too soon: 16 u of B, which
/// is three times the way.
const SHORT: f64 = 48.0 / 16_777_216.0;

fn far_lamp(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let center = DVec3::new(0.36, 0.8, -0.48) * FAR;
    let floor = disk(DVec3::new(0.0, -1.0, -3.0), DVec3::Y, 3.0);
    let flat = flat_of(&scene_of([floor, sphere(center, 1.0)]));
    let center = DVec3::from_array(flat.spheres[0].center);
    let rays: Vec<Ray<f32>> = (0..5000)
        .map(|_| {
            let aside = DVec3::new(n.between(-1.0, 1.0), 0.0, n.between(-1.0, 1.0));
            ray_to(DVec3::ZERO, DVec3::new(0.0, -1.0, -3.0) + aside)
        })
        .collect();
    let axis = center.normalize();
    let aims = rays.iter().map(|_| {
        // On the side of the lamp that faces the floor.
        let point = center - axis * 0.9 + across(axis, n) * n.between(0.0, 0.4);
        Aim::To(point.as_vec3().to_array().into())
    });
    Ok(Box::new(Journeys {
        aims: aims.collect(),
        widths: Widths::of(flat, Bounds::None),
        rays,
        legs: 2,
        judge: Box::new(|path: &Path<'_>| {
            // The disk's id follows the sphere's.
            let [floor, lamp] = [path.found[0], path.found[1]];
            if floor.id != 1 || lamp.id == 1 {
                return (1.0, 0.0);
            }
            ((1.0 - lamp.t).max(0.0), SHORT)
        }),
    }))
}

/// Within this of the radius, the shadow's edge is left to roundings.
const EDGE: f64 = 1e-3;

fn contact(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let mut trials: Vec<Box<dyn Trial>> = Vec::new();
    for radius in [1e-4, 1e-2, 1.0, 1e2, 1e4] {
        let foot = DVec3::new(0.3, -1.0, -3.0) * (3.0 * radius);
        let floor = disk(foot, DVec3::Y, 4.0 * radius);
        let flat = flat_of(&scene_of([floor, sphere(foot + DVec3::Y * radius, radius)]));
        let (mut rays, mut is_under) = (Vec::new(), Vec::new());
        for index in 0..1000 {
            let under = index % 2 == 0;
            let part = if under {
                // Most of them near the contact.
                10f64.powf(n.between(-4.0, 0.0)) * (1.0 - EDGE)
            } else {
                n.between(1.0 + EDGE, 2.0)
            };
            let point = foot + across(DVec3::Y, n) * (part * radius);
            // From below the floor, so that the sphere is not in the way.
            rays.push(ray_to(point - DVec3::new(0.3, 1.0, 0.2) * radius, point));
            is_under.push(under);
        }
        for wanted in [true, false] {
            let rays: Vec<Ray<f32>> = rays
                .iter()
                .zip(&is_under)
                .filter(|(_, under)| **under == wanted)
                .map(|(ray, _)| *ray)
                .collect();
            trials.push(Box::new(Journeys {
                widths: Widths::of(flat.clone(), Bounds::None),
                aims: vec![Aim::Towards([0.0, 1.0, 0.0].into()); rays.len()],
                rays,
                legs: 2,
                judge: Box::new(move |path: &Path<'_>| {
                    // Next to the contact, roundings may have the sphere first.
                    let is_dark = path.found[1].id == 0;
                    must(path.found[0].id != NO_HIT && is_dark == wanted)
                }),
            }));
        }
    }
    Ok(Box::new(Together(trials)))
}

fn terminator(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let size = 1e-3;
    let center = DVec3::new(0.1, 0.2, -4.0) * size;
    let ball = mesh(
        build(Builtin::Icosphere, 320),
        DMat3::IDENTITY * size,
        center,
    );
    let flat = flat_of(&scene_of([ball]));
    let oracle = Oracle::new(&flat);
    // From the side, so that the terminator is seen.
    let light = DVec3::new(1.0, 0.3, 0.2).normalize();
    let mut rays = Vec::new();
    while rays.len() < 5000 {
        let ray = ray_to(DVec3::ZERO, center + n.vector(0.9 * size));
        let truth = oracle.closest(ray.converted());
        if truth.id == NO_HIT {
            continue;
        }
        let vertices = flat.triangles[truth.row as usize].vertices;
        let [a, b, c] = vertices.map(|v| DVec3::from_array(flat.vertices[v as usize]));
        let facing = (b - a).cross(c - a).normalize().dot(light);
        let is_inside = (point_of(ray, &truth) - center).dot(light) < 0.5 * size;
        // Turned away, but for what roundings may turn back.
        if facing < -1e-3 && is_inside {
            rays.push(ray);
        }
    }
    Ok(Box::new(Journeys {
        widths: Widths::of(flat, Bounds::Tree),
        aims: vec![Aim::Towards(light.as_vec3().to_array().into()); rays.len()],
        rays,
        legs: 2,
        judge: Box::new(|path: &Path<'_>| {
            must(path.found[0].id != NO_HIT && path.found[1].id != NO_HIT)
        }),
    }))
}

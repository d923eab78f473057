//! Triangles and directions of extreme lengths.

use glam::DVec3;

use super::ON_PLANE;
use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::kernel::camera::Ray;
use crate::random::Numbers;
use crate::scene::mesh::{Builtin, build};
use crate::stability::aim::{on_an_edge, ray, ray_to};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, Classified, Exact, Finite, Residual, Same};
use crate::stability::shapes::{flat_of, mesh, scene_of, triangle};
use crate::stability::trials::aimed::Aimed;
use crate::stability::trials::alike::Alike;
use crate::stability::trials::refused::Refused;
use crate::stability::trials::together::Together;
use crate::tier::Accuracy::Textbook;

pub(super) const CASES: &[Case] = &[
    Case {
        id: "triangle/tiny-far",
        name: "an edge of 1e-6, 1000 away",
        sets_up: "A triangle of 1e-6 on the axis, and rays at points of it and beside it.",
        danger: "Its determinant, 1e-9, is below a fixed epsilon.",
        // The axis is where f32 has such numbers at all: a sheared corner is 4 u of 1e-6 off,
        // and the points are a twentieth of the triangle away from its edges.
        demands: &[Exact, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: tiny_far,
    },
    Case {
        id: "triangle/huge",
        name: "edges of 1e6, from 1 above",
        sets_up: "A triangle of 1e6 below the camera, and rays all over it and at its edges.",
        danger: "Corners of 1e6 have to cancel to a height of 1.",
        demands: &[Classified, Residual(ON_PLANE)],
        fails: &[],
        is_random: true,
        trial: huge,
    },
    Case {
        id: "triangle/direction-lengths",
        name: "directions of 1e-10 and 1e10",
        sets_up: "Rays at a sphere's edges, and the same with directions 2^33 times as long or \
                  as short.",
        danger: "A determinant grows with the direction, a fixed epsilon does not.",
        // Powers of two only shift what is computed.
        demands: &[Same(0.0)],
        fails: &[Textbook],
        is_random: true,
        trial: direction_lengths,
    },
    Case {
        id: "triangle/denormal",
        name: "triangles of 1e-40 and 1e-22, smaller scales refused",
        sets_up: "Rays at meshes whose coordinates, or their products, are below the least \
                  normal f32; and scales below 1e-15.",
        danger: "Products vanish, and 0/0 is NaN.",
        demands: &[Finite],
        fails: &[],
        is_random: true,
        trial: denormal,
    },
];

fn tiny_far(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    const EDGE: f64 = 1e-6;
    let corner = |x: f64, y: f64| DVec3::new(x * EDGE, y * EDGE, -1000.0);
    let corners = [corner(-0.5, -0.4), corner(0.5, -0.3), corner(0.1, 0.6)];
    let flat = flat_of(&scene_of([triangle(corners)]));
    let [a, b, c] = corners;
    let rays = (0..1000)
        .map(|_| {
            // Weights 0.05 inside of an edge, or outside of it.
            let inside = n.flip();
            let mut first = n.between(0.05, 0.9);
            let second = n.between(0.05, 0.95 - first.min(0.89));
            if !inside {
                first = -first;
            }
            ray_to(DVec3::ZERO, a + (b - a) * first + (c - a) * second)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::None, rays, demands)?))
}

fn huge(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let corner = |x: f64, z: f64| DVec3::new(x * 1e6, -1.0 + 0.25 * x, z * 1e6);
    let corners = [corner(-0.5, 0.4), corner(0.5, 0.3), corner(0.1, -0.6)];
    let flat = flat_of(&scene_of([triangle(corners)]));
    let rays = (0..10_000)
        .map(|index| {
            let target = if index % 2 == 0 {
                on_an_edge(&flat, n)
            } else {
                // From straight below to the far corners.
                let away = 10f64.powf(n.between(-1.0, 6.0));
                DVec3::new(n.between(-away, away), -1.0, n.between(-away, away))
            };
            ray(DVec3::ZERO, target)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::None, rays, demands)?))
}

fn direction_lengths(n: &mut Numbers, _: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let ball = mesh(
        build(Builtin::Icosphere, 320),
        glam::DMat3::IDENTITY,
        DVec3::NEG_Z * 4.0,
    );
    let widths = || Widths::of(flat_of(&scene_of([ball.clone()])), Bounds::Tree);
    let flat = widths().double;
    let of_one: Vec<Ray<f32>> = (0..4000)
        .map(|_| ray_to(n.vector(1.0), on_an_edge(&flat, n)))
        .collect();
    let factors: Vec<f32> = (0..4000)
        .map(|_| {
            if n.flip() {
                2f32.powi(33)
            } else {
                2f32.powi(-33)
            }
        })
        .collect();
    let longer = of_one.iter().zip(&factors).map(|(ray, factor)| Ray {
        direction: ray.direction * *factor,
        ..*ray
    });
    Ok(Box::new(Alike {
        right: (widths(), longer.collect()),
        left: (widths(), of_one),
        scale: factors
            .iter()
            .map(|factor| 1.0 / f64::from(*factor))
            .collect(),
        roundings: 0.0,
    }))
}

fn denormal(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let mut trials: Vec<Box<dyn Trial>> = Vec::new();
    for size in [1e-40, 1e-22] {
        let ball = mesh(
            build(Builtin::Icosphere, 80),
            glam::DMat3::IDENTITY * size,
            DVec3::NEG_Z * 2.0 * size,
        );
        let scene = scene_of([ball]);
        scene.validate()?;
        let flat = flat_of(&scene);
        let rays = (0..1000)
            .map(|index| {
                let target = on_an_edge(&flat, n);
                let length = if index % 2 == 0 {
                    1.0
                } else {
                    1.0 / size.max(1e-30)
                };
                ray(n.vector(size), target * length)
            })
            .collect();
        trials.push(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?));
    }
    let mut scene = scene_of([triangle([DVec3::X, DVec3::Y, DVec3::Z])]);
    scene.shapes[0].transform.linear *= 1e-16;
    trials.push(Box::new(Refused(vec![(scene, "singular")])));
    Ok(Box::new(Together(trials)))
}

//! The order of a triangle's corners, and corners that are none.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::random::Numbers;
use crate::scene::mesh::{Builtin, build};
use crate::scene::{Geometry, Mesh, Scene};
use crate::stability::aim::{across, on_an_edge, ray_to};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, Same};
use crate::stability::shapes::{flat_of, scene_of, triangle};
use crate::stability::trials::alike::Alike;
use crate::stability::trials::refused::Refused;
use crate::stability::trials::together::Together;
use crate::tier::Accuracy::Textbook;

pub(super) const CASES: &[Case] = &[
    Case {
        id: "triangle/reversed",
        name: "the other winding",
        sets_up: "Rays at the edges of 200 triangles, whose first two corners are then \
                  exchanged.",
        danger: "What is measured from the first corner is rounded from another one; back \
                 faces may be culled.",
        demands: &[Same(0.0)],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| orders(&[[1, 0, 2]], n),
    },
    Case {
        id: "triangle/six-orders",
        name: "all six orders of corners",
        sets_up: "The same, with corners in each other order.",
        danger: "An edge that is tested from its other end is rounded to the other side.",
        demands: &[Same(0.0)],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| {
            let others = [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
            orders(&others, n)
        },
    },
    Case {
        id: "triangle/not-a-number",
        name: "corners that are NaN, infinite or too large",
        sets_up: "A triangle with such a corner, and a mesh of 1280 with one such vertex.",
        danger: "A NaN in one box spoils the tree for all others.",
        demands: &[Demand::Refused],
        fails: &[],
        is_random: false,
        trial: |_, _| Ok(Box::new(Refused(not_numbers()))),
    },
];

/// Triangles that are far from each other, their corners in an order.
fn apart(corners: &[[DVec3; 3]], order: [usize; 3]) -> Flat<f64> {
    let in_order = corners
        .iter()
        .map(|corners| order.map(|corner| corners[corner]));
    flat_of(&scene_of(in_order.map(triangle)))
}

fn orders(others: &[[usize; 3]], n: &mut Numbers) -> Result<Box<dyn Trial>> {
    // Only one triangle may be met: at equal t the ids would tell.
    let corners: Vec<[DVec3; 3]> = (0..200)
        .map(|index| {
            let (column, row) = (f64::from(index % 20) - 9.5, f64::from(index / 20) - 4.5);
            let middle = DVec3::new(column, row, -12.0);
            let tilt = (DVec3::Z + n.vector(0.5)).normalize();
            let first = across(tilt, n) * n.between(0.1, 0.3);
            let second = tilt.cross(first);
            [first, second - first * 0.5, -second - first * 0.5].map(|side| middle + side)
        })
        .collect();
    let flat = apart(&corners, [0, 1, 2]);
    let rays: Vec<Ray<f32>> = (0..4000)
        .map(|_| {
            let target = on_an_edge(&flat, n);
            let aside = DVec3::new(n.between(-0.3, 0.3), n.between(-0.3, 0.3), 1.0);
            ray_to(target + aside * n.between(2.0, 20.0), target)
        })
        .collect();
    let trials = others.iter().map(|order| {
        let of = |order| {
            (
                Widths::of(apart(&corners, order), Bounds::Tree),
                rays.clone(),
            )
        };
        let alike = Alike {
            left: of([0, 1, 2]),
            right: of(*order),
            scale: vec![1.0; rays.len()],
            roundings: 0.0,
        };
        Box::new(alike) as Box<dyn Trial>
    });
    Ok(Box::new(Together(trials.collect())))
}

fn not_numbers() -> Vec<(Scene, &'static str)> {
    let mut scenes = Vec::new();
    for (number, reason) in [
        (f64::NAN, "finite number"),
        (f64::INFINITY, "finite number"),
        (f64::NEG_INFINITY, "finite number"),
        (1e16, "beyond 1e15"),
    ] {
        for axis in 0..3 {
            let mut corner = DVec3::ZERO;
            corner[axis] = number;
            scenes.push((scene_of([triangle([DVec3::X, corner, DVec3::Y])]), reason));
        }
        let mut ball: Mesh = build(Builtin::Icosphere, 1280);
        ball.positions[7].y = number;
        scenes.push((scene_of([Geometry::Mesh(Arc::new(ball))]), "vertex 7"));
    }
    // A place that is none makes every corner one that is none.
    let mut moved = scene_of([triangle([DVec3::X, DVec3::Y, DVec3::Z])]);
    moved.shapes[0].transform.translate.x = f64::NAN;
    scenes.push((moved, "translate"));
    let mut scaled = scene_of([triangle([DVec3::X, DVec3::Y, DVec3::Z])]);
    scaled.shapes[0].transform.linear = DMat3::IDENTITY * f64::INFINITY;
    scenes.push((scaled, "transform"));
    scenes
}

//! Triangles of hardly any width, or seen so.

use glam::DVec3;

use super::ON_PLANE;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::random::Numbers;
use crate::scene::Mesh;
use crate::stability::aim::{across, ray, ray_to};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, Classified, Exact, Finite, Residual};
use crate::stability::shapes::{flat_of, mesh, scene_of, triangle};
use crate::stability::trials::aimed::Aimed;
use crate::tier::Accuracy::Textbook;

pub(super) const CASES: &[Case] = &[
    Case {
        id: "triangle/sliver",
        name: "slivers up to ten million times as long as wide",
        sets_up: "Needles and caps, 200 of each, of a length of 1 and a width of 1e-7 to 0.1, 3 to \
                  9 away, and rays at points of them.",
        danger: "The edge functions of long edges are products that cancel. With them as weights, \
                 t is a mean of depths weighted by roundings.",
        demands: &[Classified, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: slivers,
    },
    Case {
        id: "triangle/edge-on",
        name: "triangles seen edge-on",
        sets_up: "Rays that rise out of the plane of a triangle by 0 to 1e-6 of their way.",
        danger: "The determinant is all rounding: t is divided by it, or the triangle given up.",
        demands: &[Classified, Finite, Residual(ON_PLANE)],
        fails: &[],
        is_random: true,
        trial: edge_on,
    },
    Case {
        id: "triangle/no-area",
        name: "triangles without area in a mesh",
        sets_up: "Triangles with two or three equal corners, and rays at them.",
        danger: "0/0 is NaN, and comparisons with it let it through.",
        demands: &[Exact, Finite],
        fails: &[],
        is_random: true,
        trial: without_area,
    },
    Case {
        id: "triangle/nearly-collinear",
        name: "three corners on a line, but for their rounding",
        sets_up: "Triangles whose third corner is on the line through the others, rounded, and \
                  rays at it and beside it.",
        danger: "The area is a rounding, of either sign, and t anything.",
        demands: &[Classified, Finite, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: nearly_collinear,
    },
];

/// A point of a triangle, away from its edges.
fn inner_point([a, b, c]: [DVec3; 3], n: &mut Numbers) -> DVec3 {
    let weights = [0; 3].map(|_| n.between(0.1, 1.0));
    let sum: f64 = weights.iter().sum();
    (a * weights[0] + b * weights[1] + c * weights[2]) / sum
}

fn slivers(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let corners: Vec<[DVec3; 3]> = (0..400)
        .map(|index| {
            let from = n.direction() * n.between(3.0, 9.0);
            let along = n.direction();
            let width = across(along, n) * 10f64.powf(n.between(-7.0, -1.0));
            // A needle has its shortest edge, a cap its widest angle at the second corner.
            let place = if index % 2 == 0 {
                1.0
            } else {
                n.between(0.2, 0.8)
            };
            [from, from + along * place + width, from + along]
        })
        .collect();
    let flat = flat_of(&scene_of(corners.iter().copied().map(triangle)));
    let rays = (0..10_000)
        .map(|_| {
            let vertices = flat.triangles[n.pick(corners.len())].vertices;
            let rounded = vertices.map(|vertex| DVec3::from(flat.vertices[vertex as usize]));
            let from = n.direction() * n.between(0.0, 1.0);
            ray_to(from, inner_point(rounded, n))
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

fn edge_on(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let corners: Vec<[DVec3; 3]> = (0..300)
        .map(|_| {
            let middle = n.direction() * n.between(2.0, 9.0);
            let normal = n.direction();
            let first = across(normal, n);
            let second = normal.cross(first);
            [first, second - first * 0.5, -second - first * 0.5].map(|side| middle + side)
        })
        .collect();
    let flat = flat_of(&scene_of(corners.iter().copied().map(triangle)));
    let rays = (0..10_000)
        .map(|_| {
            let [a, b, c] = corners[n.pick(corners.len())];
            let target = inner_point([a, b, c], n);
            let normal = (b - a).cross(c - a).normalize();
            let aside = across(normal, n) * n.between(1.5, 6.0);
            let rise = normal * 10f64.powf(n.between(-9.0, -6.0)) * aside.length();
            ray(target + aside + rise, -(aside + rise))
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

/// Triangles of a mesh, whose area no scene check asks for.
fn soup(corners: &[[DVec3; 3]]) -> crate::scene::Geometry {
    let soup = Mesh {
        positions: corners.as_flattened().to_vec(),
        triangles: (0..corners.len() as u32)
            .map(|index| [3 * index, 3 * index + 1, 3 * index + 2])
            .collect(),
        ..Mesh::default()
    };
    mesh(soup, glam::DMat3::IDENTITY, DVec3::ZERO)
}

fn without_area(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let mut corners = Vec::new();
    for _ in 0..100 {
        let a = n.direction() * n.between(2.0, 9.0);
        let b = a + n.direction();
        corners.extend([[a, a, a], [a, a, b], [a, b, a], [b, a, a]]);
    }
    let flat = flat_of(&scene_of([soup(&corners)]));
    let rays = (0..5000)
        .map(|_| {
            let [a, b, c] = corners[n.pick(corners.len())];
            let far = if a == b { c } else { b };
            let target = a.lerp(far, n.between(0.0, 1.0));
            ray_to(n.direction() * n.between(0.0, 1.0), target)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

fn nearly_collinear(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let corners: Vec<[DVec3; 3]> = (0..200)
        .map(|index| {
            let a = n.direction() * n.between(2.0, 9.0);
            // Along an axis it is on the line, without rounding.
            let along = if index % 2 == 0 {
                n.direction()
            } else {
                DVec3::AXES[n.pick(3)]
            };
            let b = a + along;
            [a, b, a.lerp(b, n.between(0.1, 0.9))]
        })
        .collect();
    let flat = flat_of(&scene_of([soup(&corners)]));
    let rays = (0..10_000)
        .map(|_| {
            let [a, b, _] = corners[n.pick(corners.len())];
            let beside = n.vector(1.0) * 10f64.powf(n.between(-9.0, -3.0));
            let target = a.lerp(b, n.between(0.0, 1.0)) + beside;
            ray_to(n.direction() * n.between(0.0, 1.0), target)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

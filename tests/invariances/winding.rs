//! The order of a triangle's corners.
//!
//! The decision and t take the corners by where the ray sees them, so neither changes. A normal
//! keeps its bits but the signs where the first two are exchanged: all its sums keep their
//! operands; in other orders it is rounded otherwise.

use std::sync::Arc;

use rayproof::bounds::Bounds;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::real::Real;
use rayproof::kernel::triangle::{intersect_triangle, shear_of, triangle_normal};
use rayproof::kernel::triangle_textbook;
use rayproof::kernel::two_float::TwoFloat;
use rayproof::kernel::vector::{Vec3, vec3};
use rayproof::layout::Triangle;
use rayproof::scene::{Geometry, Mesh};
use rayproof::{Accuracy, Backend, Scene};

use super::common::random::Numbers;
use super::{TIERS, assert_holds, different, generated, picture};

/// The scene with the corners of each triangle in another order.
fn wound(scene: &Scene, order: [usize; 3]) -> Scene {
    let mut scene = scene.clone();
    let turn = |corners: [u32; 3]| order.map(|corner| corners[corner]);
    for shape in &mut scene.shapes {
        match &mut shape.geometry {
            Geometry::Triangle { vertices } => *vertices = order.map(|corner| vertices[corner]),
            Geometry::Mesh(mesh) => {
                *mesh = Arc::new(Mesh {
                    triangles: mesh.triangles.iter().copied().map(turn).collect(),
                    triangle_normals: mesh.triangle_normals.iter().copied().map(turn).collect(),
                    ..Mesh::clone(mesh)
                });
            }
            _ => {}
        }
    }
    scene
}

#[test]
fn reversed_triangles_change_no_bit() {
    assert_holds(
        "reversed",
        |scene| wound(scene, [1, 0, 2]),
        Clone::clone,
        &TIERS,
        generated,
    );
}

/// The controls: with a corner in the place of another, and by the textbook's formula.
#[test]
fn other_corners_are_noticed() {
    let scene = generated(1);
    let see = |order, accuracy| {
        picture(
            &wound(&scene, order),
            &Backend::Cpu(None),
            accuracy,
            Bounds::None,
        )
    };
    let [here, there] = [[0, 1, 2], [1, 0, 2]].map(|order| see(order, Accuracy::Textbook));
    assert!(different(&here, &there) > 10);
    let mut other = scene.clone();
    for shape in &mut other.shapes {
        if let Geometry::Triangle { vertices } = &mut shape.geometry {
            vertices[0] = (vertices[0] + vertices[1]) / 2.0;
        }
    }
    let there = picture(&other, &Backend::Cpu(None), Accuracy::Robust, Bounds::None);
    assert!(different(&see([0, 1, 2], Accuracy::Robust), &there) > 10);
}

fn in_order<R: Real>(corners: [Vec3<R>; 3], order: [usize; 3]) -> Triangle<R> {
    let [a, b, c] = order.map(|corner| corners[corner].into());
    Triangle {
        a,
        padding_0: R::ZERO,
        b,
        padding_1: R::ZERO,
        c,
        padding_2: R::ZERO,
    }
}

const ORDERS: [[usize; 3]; 6] = [
    [0, 1, 2],
    [1, 0, 2],
    [0, 2, 1],
    [1, 2, 0],
    [2, 0, 1],
    [2, 1, 0],
];

/// In all orders a triangle is hit or missed alike, at the same t in every bit.
fn orders_agree<R: Real>() {
    let mut n = Numbers(9);
    let mut hits = 0;
    for _ in 0..20_000 {
        let mut vector = |reach| {
            let v = n
                .vector(reach)
                .to_array()
                .map(|x| R::from_f64((x as f32).into()));
            Vec3::from(v)
        };
        let corners = [vector(3.0), vector(3.0), vector(3.0)];
        let origin = vector(3.0);
        let ray = Ray {
            origin,
            direction: vector(1.0),
        };
        let t = ORDERS.map(|order| {
            let triangle = in_order(corners, order);
            intersect_triangle(ray, shear_of(ray), &triangle)
        });
        assert!(t.iter().all(|other| *other == t[0]), "{ray:?}");
        hits += usize::from(t[0] < R::MISS);
        let [one, other] = [0, 1].map(|order| triangle_normal(&in_order(corners, ORDERS[order])));
        assert_eq!(one, -other);
    }
    assert!(hits > 500, "{hits}");
}

#[test]
fn orders_of_corners_agree() {
    orders_agree::<f32>();
    orders_agree::<TwoFloat>();
    orders_agree::<f64>();
}

/// The control: by the textbook's formula, which triangle is hit depends on the order.
#[test]
fn the_textbook_depends_on_the_order() {
    let corners = [
        vec3(-1.0_f32, -1.0, -3.0),
        vec3(2.0, -0.7, -3.1),
        vec3(0.3, 1.9, -2.8),
    ];
    let mut n = Numbers(2);
    let differing = (0..10_000).filter(|_| {
        let target = n.between(0.0, 1.0) as f32;
        let ray = Ray {
            origin: vec3(0.0, 0.0, 0.0),
            direction: corners[0] + (corners[1] - corners[0]) * target,
        };
        let [one, other] = [ORDERS[0], ORDERS[2]]
            .map(|order| triangle_textbook::intersect_triangle(ray, &in_order(corners, order)));
        (one < f32::MAX) != (other < f32::MAX)
    });
    assert!(differing.count() > 100);
}

//! Rays in and along the faces, edges and corners of boxes.

use glam::{DMat3, DVec3};

use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::random::Numbers;
use crate::scene::mesh::{Builtin, build};
use crate::stability::aim::{ray, ray_to};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, BruteForce, Classified, Exact, Same};
use crate::stability::shapes::{flat_of, mesh, scene_of, triangle};
use crate::stability::trials::aimed::Aimed;
use crate::stability::trials::alike::Alike;
use crate::stability::trials::together::Together;
use crate::tier::Accuracy::Textbook;

pub(super) const CASES: &[Case] = &[
    Case {
        id: "bounds/in-a-face",
        name: "rays along an axis in the faces of boxes",
        sets_up: "27 cubes side by side, and rays along the axes in their faces and edges.",
        danger: "0 times infinity is NaN, and a NaN culls.",
        demands: &[Exact, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: |n, demands| along_axes(1.0, n, demands),
    },
    Case {
        id: "bounds/negative-zero",
        name: "a component that is -0",
        sets_up: "The same cubes and rays, with 0 in the direction and then with -0.",
        danger: "1 / -0 is -infinity: near and far plane change places, and the box is empty.",
        demands: &[Same(0.0), BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: negative_zero,
    },
    Case {
        id: "bounds/short-direction",
        name: "directions of 1e-20 along an axis",
        sets_up: "The same cubes and rays, the direction 2^-66 long.",
        danger: "What stands for 1 / 0 has to stay above 1 / 1e-20.",
        demands: &[Exact, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: |n, demands| along_axes(2f64.powi(-66), n, demands),
    },
    Case {
        id: "bounds/denormal-direction",
        name: "a component of 1e-39",
        sets_up: "The same cubes and rays, with 1e-39 in place of a 0.",
        danger: "1 / 1e-39 overflows to infinity where the component is not 0.",
        demands: &[Classified, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: denormal,
    },
    Case {
        id: "bounds/flat",
        name: "boxes without thickness",
        sets_up: "Triangles across each axis, stacked, and rays through them and in them.",
        danger: "A test that asks for enter < exit never enters a flat box.",
        demands: &[Exact, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: flat_boxes,
    },
    Case {
        id: "bounds/neighbours",
        name: "the edges between boxes",
        sets_up: "27 cubes side by side, and rays from anywhere at the edges they share.",
        danger: "A ray in the gap between two boxes misses the shapes of both.",
        demands: &[Classified, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: neighbours,
    },
];

/// 27 unit cubes in a block, on whole numbers.
fn cubes() -> Flat<f64> {
    let place = |index: i32| {
        DVec3::new(
            (index % 3).into(),
            (index / 3 % 3).into(),
            (index / 9).into(),
        )
    };
    let cube = |index| {
        let middle = DVec3::new(-1.5, -0.5, -8.5) + place(index);
        mesh(build(Builtin::Box, 12), DMat3::IDENTITY, middle)
    };
    flat_of(&scene_of((0..27).map(cube)))
}

/// From before or within the cubes along an axis, on multiples of a half.
fn axis_ray(length: f64, n: &mut Numbers) -> Ray<f32> {
    let place = [-2.5, -1.5, -9.5].map(|low| low + n.pick(11) as f64 / 2.0);
    let axis = DVec3::AXES[n.pick(3)] * length;
    ray(DVec3::from(place), if n.flip() { axis } else { -axis })
}

fn along_axes(length: f64, n: &mut Numbers, demands: &[Demand]) -> Result<Box<dyn Trial>> {
    let rays = (0..4000).map(|_| axis_ray(length, n)).collect();
    Ok(Box::new(Aimed::new(cubes(), Bounds::Tree, rays, demands)?))
}

/// The ray with another number for the zeros of its direction.
fn without_zeros(ray: Ray<f32>, number: f32) -> Ray<f32> {
    let d: [f32; 3] = ray.direction.into();
    let direction = d.map(|d| if d == 0.0 { number } else { d }).into();
    Ray { direction, ..ray }
}

fn negative_zero(n: &mut Numbers, _: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let rays: Vec<_> = (0..2000).map(|_| axis_ray(1.0, n)).collect();
    let other: Vec<_> = rays.iter().map(|ray| without_zeros(*ray, -0.0)).collect();
    let widths = || Widths::of(cubes(), Bounds::Tree);
    Ok(Box::new(Together(vec![
        Box::new(Aimed::new(
            cubes(),
            Bounds::Tree,
            other.clone(),
            &[BruteForce],
        )?),
        Box::new(Alike {
            scale: vec![1.0; rays.len()],
            left: (
                widths(),
                rays.iter().map(|ray| without_zeros(*ray, 0.0)).collect(),
            ),
            right: (widths(), other),
            roundings: 0.0,
        }),
    ])))
}

fn denormal(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let rays = (0..4000)
        .map(|_| without_zeros(axis_ray(1.0, n), if n.flip() { 1e-39 } else { -1e-39 }))
        .collect();
    Ok(Box::new(Aimed::new(cubes(), Bounds::Tree, rays, demands)?))
}

fn flat_boxes(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    // Across z, then with the axes turned.
    let across = |index: usize| {
        let turn = |v: DVec3| match index % 3 {
            0 => v,
            1 => DVec3::new(v.z, v.x, v.y),
            _ => DVec3::new(v.y, v.z, v.x),
        };
        let layer = (index / 3) as f64;
        let corner = |x: f64, y: f64| turn(DVec3::new(x, y, -8.0 - layer));
        triangle([corner(-8.0, -8.0), corner(8.0, -8.0), corner(8.0, 8.0)])
    };
    let flat = flat_of(&scene_of((0..24).map(across)));
    let rays = (0..4000)
        .map(|_| {
            let mut from = DVec3::from([0; 3].map(|_| n.pick(33) as f64 / 2.0 - 8.0));
            let axis = n.pick(3);
            let aslant = [-0.5, 0.0, 0.5];
            let mut direction = DVec3::from([0; 3].map(|_| aslant[n.pick(3)]));
            direction[axis] = 0.0;
            if direction != DVec3::ZERO {
                // Aslant, t is a quotient and rounded: none is 0, and no two are equal.
                from += DVec3::new(0.1875, 0.0625, 0.25);
            }
            direction[axis] = if n.flip() { 1.0 } else { -1.0 };
            ray(from, direction)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

fn neighbours(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let rays = (0..4000)
        .map(|_| {
            let mut target = DVec3::from([-2.0, -1.0, -9.0].map(|low| low + n.pick(4) as f64));
            if n.flip() {
                target[n.pick(3)] += n.between(-0.5, 0.5);
            }
            ray_to(DVec3::new(0.1, 0.2, -7.0) + n.vector(6.0), target)
        })
        .collect();
    Ok(Box::new(Aimed::new(cubes(), Bounds::Tree, rays, demands)?))
}

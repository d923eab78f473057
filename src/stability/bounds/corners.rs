//! Rays where shapes touch their boxes, and along their edges.

use glam::DVec3;

use crate::bounds::{Bounds, primitive_boxes};
use crate::error::Result;
use crate::flat::Flat;
use crate::kernel::aabb::Aabb;
use crate::random::Numbers;
use crate::scene::Geometry;
use crate::stability::aim::{a_vertex, ray, ray_to, step};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, BruteForce, Classified};
use crate::stability::shapes::{disk, flat_of, scene_of, sphere, triangle};
use crate::stability::trials::aimed::Aimed;
use crate::tier::Accuracy::Textbook;
use crate::tier::Textbook as Unpadded;

pub(super) const CASES: &[Case] = &[
    Case {
        id: "bounds/edges-and-corners",
        name: "through the edges and corners of boxes",
        sets_up: "100 shapes, and rays at edges and corners of their boxes and at vertices, to \
                  some ulp.",
        danger: "A box that fits tightly is missed by rays that its shape's test accepts.",
        demands: &[Classified, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: |n, demands| at_boxes(Start::Anywhere, n, demands),
    },
    Case {
        id: "bounds/far-start",
        name: "the same from far away",
        sets_up: "Rays that start 1e5 away from the shapes and the camera.",
        danger: "The ray's own start is rounded to more than a box is padded.",
        demands: &[Classified, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: |n, demands| at_boxes(Start::Far, n, demands),
    },
    Case {
        id: "bounds/start-on-face",
        name: "rays that start on a face or within",
        sets_up: "The same shapes, and rays from points on and in their boxes.",
        danger: "A box that is behind by a rounding is skipped with the shape in it.",
        demands: &[Classified, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: |n, demands| at_boxes(Start::OnFace, n, demands),
    },
    Case {
        id: "bounds/touching-spheres",
        name: "where a sphere touches its box",
        sets_up: "Rays along the faces of the boxes of spheres, through the point of contact, \
                  to some ulp.",
        danger: "Box and sphere are met in one point, which each rounds by itself.",
        demands: &[Classified, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: touching,
    },
    Case {
        id: "bounds/long-thin",
        name: "nearly parallel to long thin boxes",
        sets_up: "Slivers of 1000 x 1e-3 along the axes, and rays along them.",
        danger: "The interval in the thin slab is as long as the box, and its ends are rounded.",
        demands: &[Classified, BruteForce],
        fails: &[],
        is_random: true,
        trial: long_thin,
    },
];

/// A number to the nearest quarter: planes that bytes hold as they are.
fn quarters(v: DVec3) -> DVec3 {
    (v * 4.0).round() / 4.0
}

/// 100 shapes of three kinds, on quarters.
fn shapes(n: &mut Numbers) -> Flat<f64> {
    let shape = |index: usize| -> Geometry {
        let place = quarters(n.direction() * n.between(2.0, 9.0));
        let size = (1 + n.pick(4)) as f64 / 4.0;
        match index % 3 {
            0 => sphere(place, size),
            1 => disk(place, n.direction(), size),
            _ => triangle([DVec3::X, DVec3::Y, DVec3::Z].map(|axis| {
                let side = quarters(n.direction() * size);
                place + axis + side
            })),
        }
    };
    flat_of(&scene_of((0..100).map(shape)))
}

/// The shapes' own boxes, padded and as the textbook has them.
fn boxes_of(flat: &Flat<f64>) -> Vec<Aabb> {
    let unpadded = primitive_boxes(&flat.converted::<Unpadded>());
    let both = primitive_boxes(flat).into_iter().chain(unpadded);
    both.map(|(aabb, _)| aabb).collect()
}

/// A point of a box: a corner if `faces` is 3, on an edge if 2, on a face if 1.
fn point_of(aabb: &Aabb, faces: usize, n: &mut Numbers) -> DVec3 {
    let (low, high): ([f32; 3], [f32; 3]) = (aabb.low.into(), aabb.high.into());
    let first = n.pick(3);
    DVec3::from([0, 1, 2].map(|axis| {
        let (low, high) = (f64::from(low[axis]), f64::from(high[axis]));
        if (axis + first) % 3 < faces {
            if n.flip() { low } else { high }
        } else {
            n.between(low, high)
        }
    }))
}

/// Where rays at boxes start.
enum Start {
    Anywhere,
    Far,
    OnFace,
}

fn at_boxes(start: Start, n: &mut Numbers, demands: &[Demand]) -> Result<Box<dyn Trial>> {
    let flat = shapes(n);
    let boxes = boxes_of(&flat);
    let rays = (0..4000)
        .map(|_| {
            let aabb = &boxes[n.pick(boxes.len())];
            let faces = 2 + n.pick(2);
            let target = if n.flip() {
                a_vertex(&flat, n)
            } else {
                point_of(aabb, faces, n)
            };
            let target = target.map(|x| step(x, n.pick(5) as i32 - 2));
            match start {
                Start::Anywhere => ray_to(n.vector(10.0), target),
                Start::Far => ray_to(n.direction() * 1e5, target),
                Start::OnFace => {
                    let faces = n.pick(4);
                    let from = point_of(aabb, faces, n);
                    let direction = match n.pick(4) {
                        0 => DVec3::AXES[n.pick(3)],
                        1 => -DVec3::AXES[n.pick(3)],
                        _ => n.direction(),
                    };
                    ray(from, direction)
                }
            }
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

fn touching(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let ball = |_| {
        let place = quarters(n.direction() * n.between(2.0, 9.0));
        sphere(place, (1 + n.pick(4)) as f64 / 4.0)
    };
    let flat = flat_of(&scene_of((0..100).map(ball)));
    let rays = (0..4000)
        .map(|_| {
            let sphere = flat.spheres[n.pick(flat.spheres.len())];
            let first = n.pick(3);
            let outward = DVec3::AXES[first] * if n.flip() { 1.0 } else { -1.0 };
            let along = DVec3::AXES[(first + 1 + n.pick(2)) % 3];
            let mut contact = DVec3::from(sphere.center) + outward * sphere.radius;
            contact[first] = step(contact[first], n.pick(9) as i32 - 4);
            ray(contact - along * n.between(0.5, 20.0), along)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

fn long_thin(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let sliver = |_| {
        let axis = n.pick(3);
        let along = DVec3::AXES[axis] * 500.0;
        let across = DVec3::AXES[(axis + 1) % 3] * 1e-3 + DVec3::AXES[(axis + 2) % 3] * 1e-3;
        let middle = n.vector(2.0);
        triangle([middle - along, middle + along, middle + along + across])
    };
    let flat = flat_of(&scene_of((0..100).map(sliver)));
    let rays = (0..4000)
        .map(|_| {
            let vertices = flat.triangles[n.pick(100)].vertices;
            let [a, b, c] = vertices.map(|vertex| DVec3::from(flat.vertices[vertex as usize]));
            let target = a.lerp(b.lerp(c, n.between(0.0, 1.0)), n.between(0.0, 1.0));
            let along = (b - a) * n.between(0.1, 1.0);
            let aside = n.vector(1.0) * 10f64.powf(n.between(-4.0, 0.0));
            ray_to(target - along + aside, target)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

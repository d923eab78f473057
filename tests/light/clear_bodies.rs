//! Clear bodies: they bend, throw back and absorb light as the laws say.

use std::f64::consts::PI;
use std::sync::Arc;

use glam::{DMat3, DVec3};
use rayproof::Scene;
use rayproof::kernel::offset::OFFSET;
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{Geometry, Material, Mesh, Shape, Transform};

use crate::common::compare;
use crate::seen::{FAR, ROUNDING, assert_paths_agree, by_height, looking_at, mean_of};

fn glass(ior: f64, absorption: [f64; 3]) -> Material {
    Material {
        ior: Some(ior),
        absorption,
        ..Material::default()
    }
}

fn ball(y: f64, z: f64, radius: f64) -> Geometry {
    Geometry::Sphere {
        center: DVec3::new(0.0, y, z),
        radius,
    }
}

/// The corners of a box's sides, counter-clockwise seen from outside.
fn a_box(low: DVec3, high: DVec3) -> Geometry {
    let corner = |index: u32| {
        let pick = |bit: u32, low, high| if index >> bit & 1 == 0 { low } else { high };
        DVec3::new(
            pick(0, low.x, high.x),
            pick(1, low.y, high.y),
            pick(2, low.z, high.z),
        )
    };
    let sides = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    Geometry::Mesh(Arc::new(Mesh {
        positions: (0..8).map(corner).collect(),
        triangles: sides
            .iter()
            .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]])
            .collect(),
        ..Mesh::default()
    }))
}

/// Bodies of two units' thickness, from z = -2 to z = -4, of every kind.
fn slabs() -> Vec<Vec<Geometry>> {
    let plane = |z: f64, normal: f64| Geometry::Plane {
        point: DVec3::new(0.0, 0.0, z),
        normal: DVec3::new(0.0, 0.0, normal),
    };
    let disk = |z: f64, normal: f64| Geometry::Disk {
        center: DVec3::new(0.0, 0.0, z),
        normal: DVec3::new(0.0, 0.0, normal),
        radius: 1.0,
    };
    let triangle = |z: f64, side: f64| Geometry::Triangle {
        vertices: [
            DVec3::new(-side, -1.0, z),
            DVec3::new(side, -1.0, z),
            DVec3::new(0.0, 2.0, z),
        ],
    };
    let corner = DVec3::new(1.0, 0.9, 1.0);
    vec![
        vec![ball(0.0, -3.0, 1.0)],
        vec![plane(-2.0, 1.0), plane(-4.0, -1.0)],
        vec![disk(-2.0, 1.0), disk(-4.0, -1.0)],
        vec![triangle(-2.0, 1.0), triangle(-4.0, -1.0)],
        vec![a_box(-3.0 * DVec3::Z - corner, -3.0 * DVec3::Z + corner)],
    ]
}

const RATES: [f64; 3] = [0.0, 0.5, 2.0];

/// By how much of it what is left after a way of 2 may be off: the way begins as far within
/// as rays start from surfaces, whose reach is 8 at most; its length and the power round.
fn off_at_most(rate: f64) -> f64 {
    rate * (8.0 * f64::from(OFFSET) + 16.0 * ROUNDING) + 4.0 * ROUNDING
}

/// Beer's law, in bodies that do nothing else, of every kind.
#[test]
fn bodies_absorb_by_the_way_through_them() {
    for shapes in slabs() {
        let name = shapes[0].name();
        let found = mean_of(&looking_at(shapes, glass(1.0, RATES))).color;
        for (found, rate) in found.into_iter().zip(RATES) {
            let left = (-2.0 * rate).exp();
            assert!(
                (found / left - 1.0).abs() <= off_at_most(rate),
                "{name}, {rate}: {found}"
            );
        }
    }
}

/// The control: bodies whose surfaces face inward are left first, and entered then.
#[test]
fn sides_are_told_by_the_surface() {
    for shapes in slabs().into_iter().skip(1) {
        let mut scene = looking_at(shapes, glass(1.0, RATES));
        for shape in &mut scene.shapes {
            match &mut shape.geometry {
                Geometry::Plane { normal, .. } | Geometry::Disk { normal, .. } => *normal *= -1.0,
                Geometry::Triangle { vertices } => vertices.swap(1, 2),
                Geometry::Mesh(mesh) => {
                    let triangles = &mut Arc::make_mut(mesh).triangles;
                    triangles.iter_mut().for_each(|corners| corners.swap(0, 2));
                }
                Geometry::Sphere { .. } => {}
            }
        }
        assert_eq!(mean_of(&scene).color, [1.0; 3]);
    }
}

/// A transform that mirrors does not make inside outside.
#[test]
fn mirrored_bodies_absorb_as_much() {
    for shapes in slabs().into_iter().skip(3) {
        let mut scene = looking_at(shapes, glass(1.0, RATES));
        for shape in &mut scene.shapes {
            shape.transform.linear = DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0));
        }
        let found = mean_of(&scene).color;
        for (found, rate) in found.into_iter().zip(RATES) {
            let left = (-2.0 * rate).exp();
            assert!((found / left - 1.0).abs() <= off_at_most(rate), "{found}");
        }
    }
}

/// What shines within a body is seen through what is before it.
#[test]
fn things_in_a_body_are_seen_through_it() {
    let mut scene = looking_at(
        vec![ball(0.0, -3.0, 1.0), ball(0.0, -3.0, 0.25)],
        glass(1.0, RATES),
    );
    scene.materials.push(Material {
        emission: [3.0; 3],
        ..Material::default()
    });
    scene.shapes[1].material = 1;
    let found = mean_of(&scene).color;
    for (found, rate) in found.into_iter().zip(RATES) {
        let expected = 3.0 * (-0.75 * rate).exp();
        assert!(
            (found / expected - 1.0).abs() <= off_at_most(rate),
            "{rate}: {found}"
        );
    }
}

/// Straight through a pane: what both sides throw back, again and again, and what is absorbed
/// on each way.
#[test]
fn a_pane_lets_through_what_the_series_says() {
    let (ior, rate): (f64, f64) = (2.4, 0.4);
    let part = ((ior - 1.0) / (ior + 1.0)).powi(2);
    let way = (-2.0 * rate).exp();
    let sum = 1.0 / (1.0 - (part * way).powi(2));
    let through = (1.0 - part).powi(2) * way * sum;
    let back = part + (1.0 - part).powi(2) * part * way * way * sum;
    let pane = slabs().swap_remove(4);
    let mut scene = looking_at(vec![pane[0].clone()], glass(ior, [rate; 3])).with_size(8, 8);
    scene.integrator.samples = 1024;
    scene.integrator.reflections = 64;
    let mean = mean_of(&scene);
    let off = (mean.color[0] - (through + back)).abs();
    // What is absorbed counts beside chance.
    assert!(
        off < FAR * mean.error + off_at_most(rate),
        "{off}, {}",
        mean.error
    );
    // The control: what came out were nothing thrown back within.
    let once = part + (1.0 - part).powi(2) * way;
    assert!((mean.color[0] - once).abs() > FAR * mean.error + off_at_most(rate));
}

/// In light of 1 from everywhere, clear glass cannot be seen: every path that is not cut off
/// brings exactly 1.
#[test]
fn a_clear_ball_loses_nothing() {
    let seen = |reflections: u32| {
        let mut scene =
            looking_at(vec![ball(0.0, -3.0, 1.0)], glass(1.5, [0.0; 3])).with_size(24, 24);
        scene.camera.fov_degrees = 40.0;
        scene.integrator.samples = 64;
        scene.integrator.reflections = reflections;
        mean_of(&scene)
    };
    let reflections = 64;
    let mean = seen(reflections);
    // Lost is who goes in, which is 1 - F likely, and is thrown back as often as is left, each
    // time F: at most this, where F is 63/64.
    let within = f64::from(reflections - 1);
    let lost = (within / (within + 1.0)).powf(within) / (within + 1.0);
    assert!(
        mean.color[0] > 1.0 - lost - FAR * mean.error,
        "{}",
        mean.color[0]
    );
    for color in &mean.frame.color {
        // Whole samples.
        assert!(
            color[0] <= 1.0 && (color[0] * 64.0).fract() == 0.0,
            "{color:?}"
        );
    }
    // The control: who goes in does not come out.
    assert!(seen(1).color[0] < 0.7);
}

/// Through a ball, light is bent as Snell has it, on all the ways that it may take.
#[test]
fn a_ball_bends_light_as_snell_says() {
    for (ior, height) in [(1.5, 0.5), (1.5, -0.8), (1.33, 0.86), (2.4, 0.3)] {
        let mut scene =
            looking_at(vec![ball(-height, -5.0, 1.0)], glass(ior, [0.0; 3])).with_size(8, 8);
        scene.background = by_height();
        scene.integrator.samples = 1024;
        scene.integrator.reflections = 64;
        let [outside, inside] = [height, height / ior].map(f64::asin);
        let part = thrown_back(outside, inside);
        let color = |height: f64| (1.0 + height) / 2.0;
        // At the surface; through it; through it after so many turns within.
        let mut expected = part * color((2.0 * outside).sin());
        let mut straight = expected;
        for times in 0..63 {
            let turned =
                2.0 * (outside - inside) + f64::from(times) * (PI * height.signum() - 2.0 * inside);
            let share = (1.0 - part).powi(2) * part.powi(times);
            expected += share * color(-turned.sin());
            straight += share * color(0.0);
        }
        let mean = mean_of(&scene);
        let off = |expected: f64| (mean.color[0] - expected).abs();
        // A pixel is 2e-6 wide; what roundings do is far below that.
        let most = FAR * mean.error + 1e-5;
        assert!(
            off(expected) < most,
            "{ior}, {height}: {} {expected}",
            mean.color[0]
        );
        // The control: as if nothing were bent.
        assert!(off(straight) > most, "{ior}, {height}");
    }
}

/// Fresnel's equations, by the angles on both sides.
fn thrown_back(here: f64, beyond: f64) -> f64 {
    let across = (here - beyond).sin() / (here + beyond).sin();
    let along = (here - beyond).tan() / (here + beyond).tan();
    (across * across + along * along) / 2.0
}

/// Clear bodies of every kind, smooth normals among them, one behind the other.
fn all_sorts() -> Scene {
    let shape = |geometry, translate: [f64; 3], material| Shape {
        geometry,
        transform: Transform {
            linear: DMat3::from_rotation_y(0.5) * DMat3::from_rotation_x(0.3),
            translate: DVec3::from_array(translate),
        },
        material,
        velocity: DVec3::ZERO,
    };
    let pebble = Geometry::Mesh(Arc::new(build(Builtin::Icosphere, 80)));
    let cube = a_box(DVec3::splat(-0.5), DVec3::splat(0.5));
    let floor = Geometry::Plane {
        point: DVec3::new(0.0, -1.0, 0.0),
        normal: DVec3::Y,
    };
    let pane = Geometry::Disk {
        center: DVec3::ZERO,
        normal: DVec3::Z,
        radius: 0.8,
    };
    Scene {
        background: by_height(),
        ambient: [0.4; 3],
        materials: vec![
            Material::default(),
            glass(1.5, [0.1, 0.5, 1.0]),
            glass(1.0, [0.5; 3]),
        ],
        shapes: vec![
            shape(floor, [0.0; 3], 0),
            shape(ball(0.0, 0.0, 0.7), [-0.8, 0.0, -4.0], 1),
            shape(ball(0.0, 0.0, 0.4), [0.7, 0.6, -5.0], 2),
            shape(cube, [0.8, -0.3, -3.5], 1),
            shape(pebble, [0.2, -0.2, -6.0], 1),
            shape(pane, [0.0, 0.2, -3.0], 1),
        ],
        ..Scene::default()
    }
    .with_size(48, 32)
}

#[test]
fn both_backends_show_the_same_bodies() {
    assert_paths_agree(&all_sorts());
    // The control: another index is seen.
    let mut other = all_sorts();
    other.materials[1] = glass(1.5001, [0.1, 0.5, 1.0]);
    let [one, two] = [all_sorts(), other].map(|scene| mean_of(&scene).frame);
    assert!(!compare(&one, &two).pass);
}

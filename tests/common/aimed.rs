//! Rays that are aimed where a decision is hard.

#![allow(dead_code, reason = "each test uses a part")]

use std::sync::Arc;

use glam::{DMat3, DVec3, EulerRot};
use rayproof::Scene;
use rayproof::flat::Flat;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::vector::vec3;
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{Geometry, Shape, Transform};
use rayproof::stability::aim::any_corners;

use super::random::Numbers;
use super::white_scene;

/// A scene with something of everything, some of it twice in one place: shapes that stand
/// along the axes at multiples of 1/16 or, `turned`, nowhere in particular.
pub fn hard_scene(turned: bool, scale: f64) -> Scene {
    let mut shapes = Vec::new();
    let mut n = Numbers(7);
    let mut place = |geometry: Geometry, twice: bool, x: f64, y: f64, z: f64| {
        let turn = DMat3::from_euler(
            EulerRot::XYZ,
            n.between(-3.0, 3.0),
            n.between(-3.0, 3.0),
            n.between(-3.0, 3.0),
        );
        let (linear, off) = if turned {
            (turn, n.vector(0.1))
        } else {
            (DMat3::IDENTITY, DVec3::ZERO)
        };
        let transform = Transform {
            linear: linear * scale,
            translate: (DVec3::new(x, y, z) + off) * scale,
        };
        // A second one of some of them, in the place of the first.
        let times = 1 + usize::from(twice);
        shapes.extend(std::iter::repeat_n(
            Shape {
                geometry,
                transform,
                material: 0,
                velocity: DVec3::ZERO,
            },
            times,
        ));
    };
    let mesh = |kind, detail| Geometry::Mesh(Arc::new(build(kind, detail)));
    let sphere = |radius| Geometry::Sphere {
        center: DVec3::ZERO,
        radius,
    };
    let disk = |normal, radius| Geometry::Disk {
        center: DVec3::ZERO,
        normal,
        radius,
    };
    place(mesh(Builtin::Icosphere, 320), false, -2.0, 0.5, -6.0);
    place(mesh(Builtin::Box, 12), true, 1.5, 0.25, -5.0);
    place(mesh(Builtin::Tetrahedron, 16), false, 0.0, -1.5, -7.0);
    place(sphere(1.0), false, 2.0, -1.0, -7.0);
    place(sphere(0.125), true, 0.0, 0.0, -4.0);
    place(sphere(20.0), false, 0.0, 0.0, -40.0);
    // The camera is near its surface.
    place(sphere(500.0), false, 0.0, 505.0, -4.0);
    place(disk(DVec3::Z, 1.0), false, -1.0, -1.0, -5.0);
    place(disk(DVec3::new(1.0, 2.0, 2.0), 0.5), true, 1.0, 1.0, -4.0);
    place(disk(DVec3::Y, 3.0), false, 0.0, -3.0, -6.0);
    let sliver = [
        DVec3::ZERO,
        DVec3::new(2.0, 0.0, 0.5),
        DVec3::new(2.0, 1e-5, 0.5),
    ];
    place(
        Geometry::Triangle { vertices: sliver },
        true,
        -1.0,
        1.5,
        -4.0,
    );
    // In the plane of the last disk, where nothing is turned.
    let plane = Geometry::Plane {
        point: DVec3::ZERO,
        normal: DVec3::Y,
    };
    place(plane, false, 0.0, -3.0, 0.0);
    let mut scene = white_scene(shapes).with_size(16, 16);
    scene.camera.eye = DVec3::new(0.0, 0.25, 2.0) * scale;
    scene.camera.target = DVec3::new(0.0, 0.25, 0.0) * scale;
    scene
}

/// A ray in f64: where it starts, and where it goes.
type Line = (DVec3, DVec3);

/// Where a ray is aimed.
pub type Aim = fn(&Flat<f64>, &mut Numbers) -> Line;

/// Every aim, and its name.
pub const AIMS: [(&str, Aim); 10] = [
    ("an edge", |flat, n| {
        let [a, b, _] = any_corners(flat, n);
        let target = a + (b - a) * n.between(0.0, 1.0);
        towards(flat, n, target)
    }),
    ("a vertex", |flat, n| {
        let target = any_corners(flat, n)[0];
        towards(flat, n, target)
    }),
    ("the outline of a sphere", |flat, n| {
        let (center, radius) = sphere(flat, n);
        let from = origin(flat, n, center);
        let across = (center - from).cross(n.vector(1.0)).normalize();
        (from, center + across * ulps_off(n, radius) - from)
    }),
    ("the outline of a sphere, along an axis", |flat, n| {
        let (center, radius) = sphere(flat, n);
        let (along, across) = two_axes(n);
        let side = center + across * radius;
        let side = DVec3::select(
            across.abs().cmpgt(DVec3::splat(0.5)),
            ulps_of(n, side),
            side,
        );
        (side + along * n.between(1.5, 30.0) * radius, -along)
    }),
    ("the rim of a disk", |flat, n| {
        let row = n.pick(flat.disks.len());
        let disk = &flat.disks[row];
        let normal = DVec3::from(disk.normal);
        let across = normal.cross(n.vector(1.0)).normalize();
        let target = DVec3::from(disk.center) + across * ulps_off(n, disk.radius);
        towards(flat, n, target)
    }),
    ("along an edge", |flat, n| {
        let [a, b, _] = any_corners(flat, n);
        (a - (b - a) * n.between(0.0, 4.0), b - a)
    }),
    ("in the plane of a triangle", |flat, n| {
        let [a, b, c] = any_corners(flat, n);
        let mut inside = || a + (b - a) * n.between(-2.0, 3.0) + (c - a) * n.between(-2.0, 3.0);
        let (from, to) = (inside(), inside());
        (from, to - from)
    }),
    ("from a sphere or the plane of a disk", |flat, n| {
        if n.flip() {
            let (center, radius) = sphere(flat, n);
            let up = n.vector(1.0).normalize();
            return (center + up * radius, n.vector(1.0));
        }
        let disk = &flat.disks[n.pick(flat.disks.len())];
        let across = DVec3::from(disk.normal).cross(n.vector(1.0));
        (
            DVec3::from(disk.center) + across * disk.radius,
            n.vector(1.0),
        )
    }),
    ("from a triangle", |flat, n| {
        let [a, b, c] = any_corners(flat, n);
        let from = a + (b - a) * n.between(0.0, 0.5) + (c - a) * n.between(0.0, 0.5);
        (from, n.vector(1.0))
    }),
    ("anything", |flat, n| {
        let [a, b, c] = any_corners(flat, n);
        let target = a + (b - a) * n.between(0.0, 0.7) + (c - a) * n.between(0.0, 0.7);
        towards(flat, n, target)
    }),
];

/// So many rays, aimed in turn as [`AIMS`] has it; directions are of any length, and half
/// the rays are moved by 1 to 8192 units in the last place of one number, so that bounds are
/// tried where doubt ends.
pub fn aimed_rays(flat: &Flat<f64>, count: usize, seed: u64) -> Vec<Ray<f32>> {
    let mut n = Numbers(seed);
    let aims = AIMS.iter().cycle().take(count);
    aims.map(|(_, aim)| {
        let (from, direction) = aim(flat, &mut n);
        let length = match n.next() % 4 {
            0 => 10f64.powf(n.between(-12.0, 12.0)) / direction.length(),
            1 => 2f64.powi((n.next() % 32) as i32 - 16),
            _ => 1.0,
        };
        let mut from = from.as_vec3().to_array();
        let mut direction = (direction * length).as_vec3().to_array();
        if direction == [0.0; 3] {
            direction[n.pick(3)] = 1.0;
        }
        if n.flip() {
            let moved = if n.flip() { &mut from } else { &mut direction };
            let number = &mut moved[n.pick(3)];
            let ulps = 1 << n.pick(14);
            *number = step(*number, if n.flip() { ulps } else { -ulps });
        }
        let [origin, direction] = [from, direction].map(|[x, y, z]| vec3(x, y, z));
        Ray { origin, direction }
    })
    .collect()
}

/// The number so many f32 further from 0; 0 stays.
fn step(number: f32, ulps: i32) -> f32 {
    if number == 0.0 {
        return number;
    }
    f32::from_bits(number.to_bits().wrapping_add_signed(ulps))
}

/// A length that is some ulp of f32 off, or none.
fn ulps_off(n: &mut Numbers, length: f64) -> f64 {
    step(length as f32, [-8, -1, 0, 1, 8][n.pick(5)]).into()
}

fn ulps_of(n: &mut Numbers, v: DVec3) -> DVec3 {
    DVec3::from_array(v.to_array().map(|number| ulps_off(n, number)))
}

fn sphere(flat: &Flat<f64>, n: &mut Numbers) -> (DVec3, f64) {
    let sphere = &flat.spheres[n.pick(flat.spheres.len())];
    (sphere.center.into(), sphere.radius)
}

fn two_axes(n: &mut Numbers) -> (DVec3, DVec3) {
    let first = n.pick(3);
    let second = (first + 1 + n.pick(2)) % 3;
    let sign = if n.flip() { 1.0 } else { -1.0 };
    (DVec3::AXES[first] * sign, DVec3::AXES[second])
}

/// The camera, a point around the target, one far away, or one on an axis through it.
fn origin(flat: &Flat<f64>, n: &mut Numbers, target: DVec3) -> DVec3 {
    // The camera is far from nothing: its distance is the measure of the scene.
    let size = DVec3::from(flat.disks[0].center).length();
    match n.next() % 5 {
        0 | 1 => DVec3::ZERO,
        2 => target + n.vector(size),
        3 => target + n.vector(1.0) * size * 10f64.powf(n.between(-3.0, 4.0)),
        _ => target + two_axes(n).0 * n.between(0.0, 4.0) * size,
    }
}

fn towards(flat: &Flat<f64>, n: &mut Numbers, target: DVec3) -> Line {
    let from = origin(flat, n, target);
    (from, target - from)
}

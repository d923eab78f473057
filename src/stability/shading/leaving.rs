//! Rays that leave the surface that they met.

use glam::{DMat3, DVec3, Vec3};

use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::layout::NO_HIT;
use crate::oracle::{Oracle, Truth};
use crate::paths::Aim;
use crate::random::Numbers;
use crate::scene::Geometry;
use crate::scene::mesh::{Builtin, build};
use crate::stability::RAYS;
use crate::stability::aim::ray_to;
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{NoLeak, NoSelfHit, Own};
use crate::stability::shapes::{ASIDE, disk, flat_of, mesh, plane, scene_of, sphere};
use crate::stability::tally::must;
use crate::stability::trials::journeys::{Journeys, Path};
use crate::stability::trials::together::Together;
use crate::tier::Accuracy::Textbook;

pub(super) const CASES: &[Case] = &[
    Case {
        id: "shading/acne",
        name: "surfaces that shade themselves",
        sets_up: "A sphere, a closed mesh, a disk and a plane of sizes from 1e-6 to 1e6, 2 and 100 \
                  sizes away; from where a ray meets them another leaves, one in three grazing.",
        danger: "The point is off by roundings of its distance: a fixed offset is too small for \
                 what is large.",
        demands: &[NoSelfHit],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| acne(n),
    },
    Case {
        id: "shading/small-gap",
        name: "what stands close is not skipped",
        sets_up: "Two disks of sizes from 1e-6 to 1e6, a thousandth of their size apart; a ray \
                  leaves one of them for the other.",
        danger: "A fixed offset is too large for what is small: the ray starts beyond what it \
                 should meet.",
        demands: &[NoLeak],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| small_gap(n),
    },
    Case {
        id: "shading/through",
        name: "into a closed surface and out",
        sets_up: "Spheres and meshes of sizes from 1e-6 to 1e6; the ray goes on through the \
                  surface that it met.",
        danger: "With an offset to the wrong side, or too large a one, the ray never was inside.",
        demands: &[Own("the ray meets the surface a second time, from within")],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| through(n),
    },
    Case {
        id: "shading/ground",
        name: "the ground of a planet",
        sets_up: "The camera is 2 above a sphere of radius 6,371,000 on which balls of radius 1 \
                  stand; from the ground beside them rays leave towards their centres.",
        danger: "An offset in parts of the radius is as high as a house.",
        demands: &[Own(
            "the ray starts above the ground by no more than its offset, and meets the ball",
        )],
        fails: &[Textbook],
        is_random: true,
        trial: |n, _| ground(n),
    },
];

/// From a ten-thousandth of a millimetre to a thousand kilometres, if 1 is a metre.
const SIZES: [f64; 7] = [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6];

/// By how much a sphere's normal may be turned, in parts of |c| + r over r and over the cosine at
/// which it is met: l is off by so many roundings, see `docs/numerics.md`, and half the chord by
/// as much over that cosine. A ray that leaves at less tells no side of the surface.
const TURN: f64 = 20.0 / 16_777_216.0;

/// What a ray meets first, exactly.
fn meeting(flat: &Flat<f64>, ray: Ray<f32>) -> Truth {
    Oracle::new(flat).closest(ray.converted())
}

/// The point that a ray meets, within roundings of f64.
pub(super) fn point_of(ray: Ray<f32>, truth: &Truth) -> DVec3 {
    let ray: Ray<f64> = ray.converted();
    DVec3::from_array(ray.origin.into()) + DVec3::from_array(ray.direction.into()) * truth.t
}

fn a_mesh(size: f64, center: DVec3) -> Geometry {
    let ball = build(Builtin::Icosphere, 320);
    mesh(ball, DMat3::IDENTITY * size, center)
}

/// Paths of two legs: rays to points of the shape and on in a direction on the side from which
/// they came.
fn leave(geometry: Geometry, size: f64, center: DVec3, count: usize, n: &mut Numbers) -> Journeys {
    let flat = flat_of(&scene_of([geometry]));
    let (mut rays, mut aims) = (Vec::new(), Vec::new());
    while rays.len() < count {
        let ray = ray_to(DVec3::ZERO, center + n.vector(0.7 * size));
        let truth = meeting(&flat, ray);
        if truth.id == NO_HIT {
            continue;
        }
        let normal = normal_at(&flat, ray, &truth);
        let mut direction = n.direction();
        if rays.len().is_multiple_of(3) {
            direction -= normal * (direction.dot(normal) * 0.999);
        }
        if direction.dot(normal) < 0.0 {
            direction = -direction;
        }
        let came: Ray<f64> = ray.converted();
        let cosine = -DVec3::from_array(came.direction.into())
            .normalize()
            .dot(normal);
        if direction.dot(normal) < TURN * (center.length() + size) / (size * cosine) {
            continue;
        }
        rays.push(ray);
        aims.push(Aim::Towards(direction.as_vec3().to_array().into()));
    }
    Journeys {
        widths: Widths::of(flat, Bounds::Tree),
        rays,
        aims,
        legs: 2,
        // All shapes here are convex: from outside, nothing is met.
        judge: Box::new(|path: &Path<'_>| must(path.found[1].id == NO_HIT)),
    }
}

/// The unit normal of what a ray meets, on the side from which it comes.
fn normal_at(flat: &Flat<f64>, ray: Ray<f32>, truth: &Truth) -> DVec3 {
    let normal = if let [sphere] = flat.spheres.as_slice() {
        point_of(ray, truth) - DVec3::from_array(sphere.center)
    } else if let [disk] = flat.disks.as_slice() {
        DVec3::from_array(disk.normal)
    } else if let [plane] = flat.planes.as_slice() {
        DVec3::from_array(plane.normal)
    } else {
        let vertices = flat.triangles[truth.row as usize].vertices;
        let [a, b, c] = vertices.map(|v| DVec3::from_array(flat.vertices[v as usize]));
        (b - a).cross(c - a)
    };
    let direction: Ray<f64> = ray.converted();
    let normal = normal.normalize();
    if DVec3::from_array(direction.direction.into()).dot(normal) > 0.0 {
        return -normal;
    }
    normal
}

fn acne(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let mut trials: Vec<Box<dyn Trial>> = Vec::new();
    let count = RAYS / (SIZES.len() * 2 * 4);
    for size in SIZES {
        for distance in [2.0, 100.0] {
            let center = ASIDE * (size * distance);
            let tilt = DVec3::new(-0.2, -0.3, 0.9);
            for geometry in [
                sphere(center, size),
                a_mesh(size, center),
                disk(center, tilt, size),
                plane(center, tilt),
            ] {
                trials.push(Box::new(leave(geometry, size, center, count, n)));
            }
        }
    }
    Ok(Box::new(Together(trials)))
}

/// Two legs between disks, straight across the gap.
fn small_gap(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let mut trials: Vec<Box<dyn Trial>> = Vec::new();
    for size in SIZES {
        let center = ASIDE * (size * 2.0);
        let across = DVec3::new(-0.2, -0.3, 0.9).normalize();
        let far = center - across * (size * 1e-3);
        let flat = flat_of(&scene_of([
            disk(center, across, size),
            disk(far, across, size),
        ]));
        // Rays start in the gap, so that they meet the near disk from behind.
        let start = |n: &mut Numbers| center - across * (size * 0.5e-3) + n.vector(size * 0.1e-3);
        let aim = |n: &mut Numbers| center + across.cross(n.direction()) * (0.5 * size);
        let rays = (0..RAYS / 10 / SIZES.len()).map(|_| ray_to(start(n), aim(n)));
        let rays: Vec<Ray<f32>> = rays.collect();
        let away = -across;
        let aims = vec![Aim::Towards(away.as_vec3().to_array().into()); rays.len()];
        trials.push(Box::new(Journeys {
            widths: Widths::of(flat, Bounds::None),
            rays,
            aims,
            legs: 2,
            judge: Box::new(|path: &Path<'_>| must(path.found[0].id == 0 && path.found[1].id == 1)),
        }));
    }
    Ok(Box::new(Together(trials)))
}

/// Two legs: into a closed surface, and to it from within.
fn through(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let mut trials: Vec<Box<dyn Trial>> = Vec::new();
    for size in SIZES {
        let center = ASIDE * (size * 3.0);
        for geometry in [sphere(center, size), a_mesh(size, center)] {
            let flat = flat_of(&scene_of([geometry]));
            let rays = (0..RAYS / 10 / SIZES.len())
                .map(|_| ray_to(DVec3::ZERO, center + n.vector(0.5 * size)));
            let rays: Vec<Ray<f32>> = rays.collect();
            let aims = rays.iter().map(|ray| Aim::Towards(ray.direction));
            trials.push(Box::new(Journeys {
                aims: aims.collect(),
                widths: Widths::of(flat, Bounds::Tree),
                rays,
                legs: 2,
                judge: Box::new(|path: &Path<'_>| {
                    must(path.found.iter().all(|found| found.id != NO_HIT))
                }),
            }));
        }
    }
    Ok(Box::new(Together(trials)))
}

/// Radius of the planet, in metres, and the camera's height.
const PLANET: f64 = 6_371_000.0;
const HEIGHT: f64 = 2.0;

fn ground(n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let mut shapes = vec![sphere(-DVec3::Y * (PLANET + HEIGHT), PLANET)];
    let foot = |v: DVec3| v - DVec3::Y * (HEIGHT + v.length_squared() / (2.0 * PLANET));
    let places: Vec<DVec3> = (0..20)
        .map(|_| {
            let angle = n.between(0.0, std::f64::consts::TAU);
            DVec3::new(angle.cos(), 0.0, angle.sin()) * n.between(8.0, 200.0)
        })
        .collect();
    shapes.extend(
        places
            .iter()
            .map(|place| sphere(foot(*place) + DVec3::Y, 1.0)),
    );
    let flat = flat_of(&scene_of(shapes));
    let (mut rays, mut aims) = (Vec::new(), Vec::new());
    while rays.len() < 2000 {
        let ball = n.pick(places.len());
        let beside = places[ball] + DVec3::Y.cross(n.direction()) * 3.0;
        let ray = ray_to(DVec3::ZERO, foot(beside));
        if meeting(&flat, ray).id != 0 {
            continue;
        }
        let center = flat.spheres[1 + ball].center;
        rays.push(ray);
        aims.push(Aim::To(
            DVec3::from_array(center).as_vec3().to_array().into(),
        ));
    }
    let planet = flat.spheres[0];
    let on_foot = Journeys {
        widths: Widths::of(flat.clone(), Bounds::Tree),
        rays: rays.clone(),
        aims: aims.clone(),
        legs: 1,
        judge: Box::new(move |path: &Path<'_>| {
            let start = Vec3::from_array(path.end.origin.into()).as_dvec3();
            let height = start.distance(planet.center.into()) - planet.radius;
            let most = OFFSET_AND_ERROR * (2.0 * taxicab(start) + PLANET * 2f64.powi(-20));
            (if height > 0.0 { height } else { f64::INFINITY }, most)
        }),
    };
    let to_the_balls = Journeys {
        widths: Widths::of(flat, Bounds::Tree),
        rays,
        aims,
        legs: 2,
        judge: Box::new(|path: &Path<'_>| {
            let [ground, ball] = [path.found[0], path.found[1]];
            must(ground.id == 0 && ball.id != 0 && ball.id != NO_HIT && ball.t < 1.0)
        }),
    };
    Ok(Box::new(Together(vec![
        Box::new(on_foot),
        Box::new(to_the_balls),
    ])))
}

/// 48 u by which a ray is lifted, and the 12 u by which its start is off.
const OFFSET_AND_ERROR: f64 = 60.0 / 16_777_216.0;

fn taxicab(v: DVec3) -> f64 {
    v.abs().element_sum()
}

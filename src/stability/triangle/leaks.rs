//! Rays at what triangles share: none slips through.

use glam::{DMat3, DVec3};

use super::ON_PLANE;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::flat::Flat;
use crate::random::Numbers;
use crate::scene::Mesh;
use crate::scene::mesh::{Builtin, build};
use crate::stability::RAYS;
use crate::stability::aim::{a_vertex, on_an_edge, ray_to};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, Classified, NoLeak, Residual};
use crate::stability::shapes::{flat_of, mesh, scene_of};
use crate::stability::trials::aimed::Aimed;
use crate::tier::Accuracy::Textbook;

pub(super) const CASES: &[Case] = &[
    Case {
        id: "triangle/shared-edges",
        name: "the edges of a closed mesh",
        sets_up: "Rays from within a sphere of 1280 triangles to its edges.",
        danger: "Each triangle rounds the edge from its own first corner: some rays are \
                 outside of both.",
        demands: &[NoLeak, Classified, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: |n, demands| ball(NEAR, 1.0, on_an_edge, n, demands),
    },
    Case {
        id: "triangle/shared-vertices",
        name: "the vertices of a closed mesh",
        sets_up: "Rays from within the same sphere to its vertices.",
        danger: "Five or six triangles have to agree, each by other products.",
        demands: &[NoLeak, Classified, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: |n, demands| ball(NEAR, 1.0, a_vertex, n, demands),
    },
    Case {
        id: "triangle/far-off",
        name: "a closed mesh far off, the camera with it",
        sets_up: "The sphere, the camera and the rays are at (148376, 1234, -223423).",
        danger: "In f32 a vertex there is 1/64 off unless the camera's place is subtracted \
                 first, in f64.",
        demands: &[NoLeak, Classified, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: with_the_camera,
    },
    Case {
        id: "triangle/far-from-camera",
        name: "a closed mesh far from the camera, rays from within",
        sets_up: "The sphere, of radius 100, is at (148376, 1234, -223423) from the camera, and \
                  rays start in it.",
        danger: "Corner times direction is rounded to more than a triangle is wide, unless \
                 the ray's start is subtracted first.",
        demands: &[NoLeak, Classified, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: |n, demands| ball(FAR / 100.0, 100.0, on_an_edge, n, demands),
    },
    Case {
        id: "triangle/small-mesh",
        name: "a closed mesh of radius 1e-15",
        sets_up: "The sphere, scaled by 1e-15, and rays from within to its edges.",
        danger: "Every determinant is below any fixed epsilon.",
        demands: &[NoLeak, Classified, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: |n, demands| ball(NEAR, 1e-15, on_an_edge, n, demands),
    },
    Case {
        id: "triangle/large-mesh",
        name: "a closed mesh of radius 1e15",
        sets_up: "The sphere, scaled by 1e15, and rays from within to its edges.",
        danger: "A product of three lengths overflows.",
        demands: &[NoLeak, Classified, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: |n, demands| ball(NEAR, 1e15, on_an_edge, n, demands),
    },
    Case {
        id: "triangle/fan",
        name: "100 triangles around a vertex",
        sets_up: "Two cones of 100 triangles, base to base, and rays from within to their tips \
                  and edges.",
        danger: "At the tip, one wrong sign of a hundred opens a hole.",
        demands: &[NoLeak, Classified],
        fails: &[Textbook],
        is_random: true,
        trial: fan,
    },
    Case {
        id: "triangle/uneven",
        name: "large triangles beside tiny ones",
        sets_up: "A tetrahedron whose triangles are cut in three at random points, 300 times, \
                  and rays from within to the edges.",
        danger: "The edge is long for the one and the vertex near for the other, so they \
                 round it differently.",
        // Where slivers overlap by a rounding, their t decides.
        demands: &[NoLeak, Classified, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: uneven,
    },
    Case {
        id: "triangle/terrain",
        name: "a terrain from above",
        sets_up: "Rays from above hills of 20,000 triangles to edges between them.",
        danger: "A hole of one ray in ten thousand is a dark dot in each picture.",
        demands: &[NoLeak, Classified, Residual(ON_PLANE)],
        fails: &[Textbook],
        is_random: true,
        trial: terrain,
    },
];

/// Beside the camera, which is within the sphere, but not in its middle.
const NEAR: DVec3 = DVec3::new(0.15, -0.25, 0.1);

/// Where Embree's tests have it.
const FAR: DVec3 = DVec3::new(148_376.0, 1234.0, -223_423.0);

/// What a ray is aimed at.
type Target = fn(&Flat<f64>, &mut Numbers) -> DVec3;

/// Along no axis.
fn turned() -> DMat3 {
    DMat3::from_euler(glam::EulerRot::XYZ, 0.3, 0.5, 0.7)
}

/// A ball of triangles, at a place in parts of its radius.
fn ball(
    place: DVec3,
    radius: f64,
    target: Target,
    n: &mut Numbers,
    demands: &[Demand],
) -> Result<Box<dyn Trial>> {
    let geometry = mesh(
        build(Builtin::Icosphere, 1280),
        turned() * radius,
        place * radius,
    );
    from_within(
        &flat_of(&scene_of([geometry])),
        place * radius,
        0.5 * radius,
        (target, RAYS),
        n,
        demands,
    )
}

/// Rays from near a point in a closed mesh.
fn from_within(
    flat: &Flat<f64>,
    middle: DVec3,
    reach: f64,
    (target, count): (Target, usize),
    n: &mut Numbers,
    demands: &[Demand],
) -> Result<Box<dyn Trial>> {
    let rays = (0..count)
        .map(|_| {
            let from = middle + n.direction() * n.between(0.0, reach);
            ray_to(from, target(flat, n))
        })
        .collect();
    Ok(Box::new(Aimed::new(
        flat.clone(),
        Bounds::Tree,
        rays,
        demands,
    )?))
}

fn with_the_camera(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let geometry = mesh(build(Builtin::Icosphere, 1280), turned(), FAR + NEAR);
    let mut scene = scene_of([geometry]);
    scene.camera.eye += FAR;
    scene.camera.target += FAR;
    from_within(&flat_of(&scene), NEAR, 0.5, (on_an_edge, RAYS), n, demands)
}

fn fan(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    const SIDES: u32 = 100;
    let mut positions = vec![DVec3::Z, DVec3::NEG_Z];
    let mut triangles = Vec::new();
    for side in 0..SIDES {
        let angle = std::f64::consts::TAU * f64::from(side) / f64::from(SIDES);
        positions.push(DVec3::new(angle.cos(), angle.sin(), 0.0));
        let [this, next] = [side, (side + 1) % SIDES].map(|side| side + 2);
        triangles.extend([[0, this, next], [1, next, this]]);
    }
    let cones = Mesh {
        positions,
        triangles,
        ..Mesh::default()
    };
    let flat = flat_of(&scene_of([mesh(cones, turned(), NEAR)]));
    // Every fourth of its corners is a tip.
    let target: Target = |flat, n| {
        if n.flip() {
            a_vertex(flat, n)
        } else {
            on_an_edge(flat, n)
        }
    };
    from_within(&flat, NEAR, 0.4, (target, RAYS / 5), n, demands)
}

fn uneven(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let mut solid = build(Builtin::Tetrahedron, 4);
    for _ in 0..300 {
        let cut = n.pick(solid.triangles.len());
        let [a, b, c] = solid.triangles[cut];
        let weights = [0; 3].map(|_| 10f64.powf(n.between(-4.0, 0.0)));
        let sum: f64 = weights.iter().sum();
        let corners = [a, b, c].map(|corner| solid.positions[corner as usize]);
        let parts = corners.iter().zip(weights);
        let point = parts.map(|(corner, weight)| *corner * weight / sum).sum();
        let new = solid.positions.len() as u32;
        solid.positions.push(point);
        solid.triangles[cut] = [a, b, new];
        solid.triangles.extend([[b, c, new], [c, a, new]]);
    }
    let flat = flat_of(&scene_of([mesh(solid, turned(), NEAR)]));
    from_within(&flat, NEAR, 0.1, (on_an_edge, RAYS / 5), n, demands)
}

fn terrain(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let hills = mesh(
        build(Builtin::Terrain, 20_000),
        DMat3::IDENTITY,
        DVec3::NEG_Y * 5.0,
    );
    let flat = flat_of(&scene_of([hills]));
    let is_inner = |point: &DVec3| point.x.abs() < 4.0 && point.z.abs() < 4.0;
    let rays = (0..RAYS)
        .map(|_| {
            let target = loop {
                let target = on_an_edge(&flat, n);
                if is_inner(&target) {
                    break target;
                }
            };
            let aside = DVec3::new(n.between(-1.0, 1.0), 0.0, n.between(-1.0, 1.0));
            ray_to(target + aside + DVec3::Y * 6.0, target)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

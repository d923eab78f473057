//! Lists of volumes, seen from the camera: its pictures are those of brute force.

use glam::{DMat3, DVec3};

use crate::bounds::Bounds;
use crate::bounds::ball::bounding_ball;
use crate::error::Result;
use crate::random::Numbers;
use crate::scene::mesh::{Builtin, build};
use crate::scene::{Mesh, Scene};
use crate::stability::aim::across;
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::BruteForce;
use crate::stability::shapes::{flat_of, mesh, scene_of};
use crate::stability::trials::pictures::Pictures;
use crate::stability::trials::together::Together;

pub(super) const CASES: &[Case] = &[
    Case {
        id: "bounds/tight-sphere",
        name: "a bounding sphere that touches a vertex",
        sets_up: "Pictures of meshes, from close by to 1e5 away, of the vertex that their \
                  bounding sphere touches, a pixel as wide as an ulp or as the mesh.",
        danger: "The ray at the vertex passes the sphere by a rounding, and the mesh with it.",
        demands: &[BruteForce],
        fails: &[],
        is_random: true,
        trial: |n, _| at_vertices(Bounds::Spheres { levels: 2 }, n),
    },
    Case {
        id: "bounds/tight-box",
        name: "a bounding box that touches a vertex",
        sets_up: "The same pictures with boxes.",
        danger: "The ray at the vertex passes the box by a rounding, and the mesh with it.",
        demands: &[BruteForce],
        fails: &[],
        is_random: true,
        trial: |n, _| at_vertices(Bounds::Boxes { levels: 2 }, n),
    },
    Case {
        id: "bounds/tight-tile",
        name: "a tile of the screen that touches a sphere",
        sets_up: "The same pictures, and for each tile the spheres that its rays may meet.",
        danger: "The cone around a tile is so narrow that its cosine is 1.",
        demands: &[BruteForce],
        fails: &[],
        is_random: true,
        trial: |n, _| at_vertices(Bounds::Screen { levels: 2 }, n),
    },
];

/// Pixels of a side: the middle of one is the middle of the picture.
const SIDE: u32 = 65;

/// Pictures of a case.
const PICTURES: usize = 8;

/// One triangle, or a few.
fn small_mesh(index: usize, n: &mut Numbers) -> Mesh {
    if index.is_multiple_of(2) {
        return build(Builtin::Icosphere, 20);
    }
    Mesh {
        positions: [0; 3].map(|_| n.direction()).to_vec(),
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    }
}

/// A picture of the vertex that is farthest out, the line of sight along the sphere.
fn at_a_vertex(index: usize, n: &mut Numbers) -> Scene {
    let solid = small_mesh(index, n);
    let points: Vec<_> = solid.positions.iter().map(|point| (*point, 0.0)).collect();
    let (middle, _) = bounding_ball(&points).unwrap_or_default();
    let out = |point: &DVec3| point.distance(middle);
    let vertex = solid.positions.iter().copied();
    let vertex = vertex.fold(
        middle,
        |far, point| if out(&point) > out(&far) { point } else { far },
    );
    let forward = across(vertex - middle, n);
    // From close by to far away, and of each some narrow and some wide.
    let part = index as f64 / (PICTURES - 1) as f64;
    let distance = 10f64.powf(5.0 * part);
    let mut scene = scene_of([mesh(solid, DMat3::IDENTITY, DVec3::ZERO)]).with_size(SIDE, SIDE);
    scene.camera.eye = vertex - forward * distance;
    scene.camera.target = vertex;
    scene.camera.up = (vertex - middle).normalize();
    // The width of the picture in parts of the distance, from some ulp to the whole mesh.
    let narrow = (3 * index % PICTURES) as f64 / (PICTURES - 1) as f64;
    let width = 10f64.powf(-6.0 * narrow) / distance;
    scene.camera.fov_degrees = (2.0 * width.atan()).to_degrees();
    scene
}

fn at_vertices(bounds: Bounds, n: &mut Numbers) -> Result<Box<dyn Trial>> {
    let pictures = (0..PICTURES).map(|index| {
        let scene = at_a_vertex(index, n);
        Box::new(Pictures::new(flat_of(&scene), bounds)) as Box<dyn Trial>
    });
    Ok(Box::new(Together(pictures.collect())))
}

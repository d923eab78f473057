//! Trees of every shape.

use std::sync::Arc;

use glam::DVec3;
use rayproof::Scene;
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{Geometry, Mesh, Shape, Transform};

use super::common::aimed::hard_scene;
use super::common::random::Numbers;
use super::common::white_scene;

/// Where the scenes stand, seen from the camera.
pub const CENTER: DVec3 = DVec3::new(0.25, -0.5, -4.0);

/// How far they reach from there.
pub const REACH: f64 = 2.0;

/// Triangles of any corners, as a mesh around [`CENTER`].
fn mesh_of(triangles: impl Iterator<Item = [DVec3; 3]>) -> Scene {
    let mut mesh = Mesh::default();
    for corners in triangles {
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(corners);
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    standing(Geometry::Mesh(Arc::new(mesh)))
}

fn standing(geometry: Geometry) -> Scene {
    let transform = Transform {
        translate: CENTER,
        ..Transform::default()
    };
    white_scene(vec![Shape {
        geometry,
        transform,
        material: 0,
        velocity: DVec3::ZERO,
    }])
}

/// Every shape of tree, and its name.
pub fn scenes() -> Vec<(&'static str, Scene)> {
    let mut n = Numbers(1);
    let mut near = move |center: DVec3, reach: f64| [0; 3].map(|_| center + n.vector(reach));
    let triangle = [DVec3::X, DVec3::Y, -DVec3::ONE];
    let few = (0..3).map(|i| triangle.map(|corner| corner + DVec3::Z * f64::from(i)));
    vec![
        (
            "a mesh",
            standing(Geometry::Mesh(Arc::new(build(Builtin::Icosphere, 5120)))),
        ),
        (
            "equal centroids",
            mesh_of((1..=10_000).map(|i| triangle.map(|corner| corner * f64::from(i) * 2e-4))),
        ),
        (
            "overlapping",
            mesh_of((0..2000).map(|_| near(DVec3::ZERO, 2.0))),
        ),
        (
            "flat",
            mesh_of((0..4096).map(|i| {
                let corner = DVec3::new(f64::from(i % 64), f64::from(i / 64), 0.0) / 16.0 - 2.01;
                let corner = corner.with_z(0.0);
                [corner, corner + DVec3::X / 16.0, corner + DVec3::Y / 16.0]
            })),
        ),
        (
            "without area",
            mesh_of((0..2000).map(|i| {
                let [a, b, _] = near(DVec3::ZERO, 2.0);
                if i % 2 == 0 { [a, a, a] } else { [a, b, a] }
            })),
        ),
        ("one place", mesh_of((0..1000).map(|_| triangle))),
        ("one leaf", mesh_of(few)),
        ("everything", hard_scene(true, 1.0)),
    ]
}

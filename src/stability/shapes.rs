//! Small scenes, whose numbers are the same in every tier.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::flat::Flat;
use crate::flatten::flatten;
use crate::scene::{Geometry, Material, Mesh, Scene, Shape, Transform};

/// A unit vector along no axis.
pub const ASIDE: DVec3 = DVec3::new(0.36, 0.48, -0.8);

/// Another one, on the other side.
pub const ASKEW: DVec3 = DVec3::new(0.48, 0.64, 0.6);

/// Shapes in white, in light from everywhere, the camera at the origin.
pub fn white_scene(shapes: Vec<Shape>) -> Scene {
    Scene {
        ambient: [1.0; 3],
        materials: vec![Material {
            name: "white".into(),
            albedo: [0.8; 3],
            ..Material::default()
        }],
        shapes,
        ..Scene::default()
    }
}

/// The same of shapes that stay where they are.
pub fn scene_of(shapes: impl IntoIterator<Item = Geometry>) -> Scene {
    let shape = |geometry| Shape {
        geometry,
        transform: Transform::default(),
        material: 0,
        velocity: DVec3::ZERO,
    };
    white_scene(shapes.into_iter().map(shape).collect())
}

/// The scene as plain arrays, each number rounded to f32: no tier has another scene than the
/// oracle.
pub fn flat_of(scene: &Scene) -> Flat<f64> {
    let mut flat = flatten::<f64>(scene).converted::<f32>().converted::<f64>();
    flat.take_powers_anew();
    flat
}

/// A sphere.
pub fn sphere(center: DVec3, radius: f64) -> Geometry {
    Geometry::Sphere { center, radius }
}

/// A plane.
pub fn plane(point: DVec3, normal: DVec3) -> Geometry {
    Geometry::Plane { point, normal }
}

/// A disk.
pub fn disk(center: DVec3, normal: DVec3, radius: f64) -> Geometry {
    Geometry::Disk {
        center,
        normal,
        radius,
    }
}

/// A triangle.
pub fn triangle(vertices: [DVec3; 3]) -> Geometry {
    Geometry::Triangle { vertices }
}

/// A mesh without vertex normals, scaled, then moved.
pub fn mesh(mut mesh: Mesh, linear: DMat3, offset: DVec3) -> Geometry {
    for position in &mut mesh.positions {
        *position = linear * *position + offset;
    }
    mesh.normals.clear();
    mesh.triangle_normals.clear();
    Geometry::Mesh(Arc::new(mesh))
}

//! Scenes that nobody thought of.

#![allow(dead_code, reason = "each test uses a part")]

use glam::{DMat3, EulerRot};
use rayproof::Scene;
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::*;

pub use rayproof::random::Numbers;

fn color(n: &mut Numbers) -> Rgb {
    [0; 3].map(|_| n.between(0.0, 1.0))
}

/// Shapes of every kind around the camera, all lengths times `scale`.
pub fn random_scene(seed: u64, scale: f64) -> Scene {
    let mut n = Numbers(seed);
    let at = |n: &mut Numbers| n.vector(6.0 * scale);
    let mut shapes = Vec::new();
    for index in 0..30 {
        let geometry = match index % 6 {
            0 | 1 => Geometry::Sphere {
                center: at(&mut n),
                radius: n.between(0.01, 2.0) * scale,
            },
            2 => Geometry::Plane {
                point: at(&mut n),
                normal: n.vector(1.0),
            },
            3 => Geometry::Disk {
                center: at(&mut n),
                normal: n.vector(1.0),
                radius: n.between(0.01, 2.0) * scale,
            },
            4 => Geometry::Triangle {
                vertices: [at(&mut n), at(&mut n), at(&mut n)],
            },
            _ => Geometry::Mesh(std::sync::Arc::new(build(Builtin::ALL[index % 5], 100))),
        };
        let turn = DMat3::from_euler(
            EulerRot::XYZ,
            n.between(-3.0, 3.0),
            n.between(-3.0, 3.0),
            n.between(-3.0, 3.0),
        );
        let linear = match geometry {
            Geometry::Mesh(_) => turn * DMat3::from_diagonal(n.vector(1.0) * scale),
            _ => turn,
        };
        let translate = n.vector(scale);
        let transform = Transform { linear, translate };
        shapes.push(Shape {
            geometry,
            transform,
            material: index % 5,
            velocity: glam::DVec3::ZERO,
        });
    }
    let directional = Light::Directional {
        direction: n.vector(1.0),
        color: color(&mut n),
        shadow: false,
    };
    let falloff = if seed.is_multiple_of(2) {
        Falloff::None
    } else {
        Falloff::InverseSquare
    };
    let point = Light::Point {
        position: at(&mut n),
        color: color(&mut n),
        falloff,
        shadow: false,
    };
    Scene {
        camera: Camera {
            eye: at(&mut n),
            target: at(&mut n),
            up: n.vector(1.0),
            fov_degrees: n.between(5.0, 150.0),
            sampling: PixelSampling::Center,
            ..Camera::default()
        },
        background: Background {
            from: color(&mut n),
            to: color(&mut n),
            offset: n.between(-1.0, 1.0),
            slope: n.between(-1.0, 1.0),
        },
        ambient: color(&mut n),
        lights: vec![directional, point],
        materials: (0..5)
            .map(|index| Material {
                name: index.to_string(),
                albedo: color(&mut n),
                ..Material::default()
            })
            .collect(),
        shapes,
        ..Scene::default()
    }
    .with_size(61, 47)
}

//! Builds a scene in code, renders it and writes it as a PNG.
//!
//! ```console
//! $ cargo run --example build_a_scene -- spiral.png
//! ```

use std::path::PathBuf;

use glam::DVec3;
use rayproof::scene::{
    Background, Camera, Falloff, Geometry, Image, Light, Material, PixelSampling, Scene, Shape,
    Transfer, Transform,
};
use rayproof::{Accuracy, Backend, Error, Layer, Unwatched, render};

const BALLS: u32 = 40;

fn main() -> miette::Result<()> {
    let file = PathBuf::from(std::env::args().nth(1).unwrap_or("spiral.png".into()));
    Ok(draw(&file)?)
}

fn draw(file: &std::path::Path) -> Result<(), Error> {
    let scene = spiral();
    let backend = Backend::auto()?;
    let picture = render(&scene, &backend, Accuracy::Robust, &Unwatched)?;
    picture
        .frame
        .write_png(file, Layer::Color, scene.image.transfer)?;
    println!(
        "{}: {} shapes on the {}",
        file.display(),
        picture.stats.primitives,
        picture.stats.backend
    );
    Ok(())
}

/// Balls in a spiral on a floor, each smaller than the one before.
fn spiral() -> Scene {
    let floor = Shape {
        geometry: Geometry::Plane {
            point: DVec3::ZERO,
            normal: DVec3::Y,
        },
        transform: Transform::default(),
        material: 0,
        velocity: glam::DVec3::ZERO,
    };
    Scene {
        image: Image {
            width: 400,
            height: 300,
            transfer: Transfer::Srgb,
        },
        camera: Camera {
            eye: DVec3::new(0.0, 5.0, 6.0),
            target: DVec3::new(0.0, 0.2, 0.0),
            up: DVec3::Y,
            fov_degrees: 45.0,
            sampling: PixelSampling::Center,
            ..Camera::default()
        },
        background: Background::plain([0.02, 0.03, 0.05]),
        ambient: [0.08, 0.08, 0.1],
        lights: vec![Light::Point {
            position: DVec3::new(2.0, 5.0, 1.0),
            color: [30.0, 28.0, 24.0],
            falloff: Falloff::InverseSquare,
            shadow: false,
        }],
        materials: vec![
            Material {
                name: "floor".into(),
                albedo: [0.5, 0.5, 0.5],
                ..Material::default()
            },
            Material {
                name: "ball".into(),
                albedo: [0.9, 0.55, 0.2],
                ..Material::default()
            },
        ],
        shapes: std::iter::once(floor).chain((0..BALLS).map(ball)).collect(),
        groups: Vec::new(),
        ..Scene::default()
    }
}

/// The ball at place `index` of the spiral, resting on the floor.
fn ball(index: u32) -> Shape {
    let outward = 1.0 - f64::from(index) / f64::from(BALLS);
    let (sin, cos) = (0.5 * f64::from(index)).sin_cos();
    let radius = 0.35 * outward;
    Shape {
        geometry: Geometry::Sphere {
            center: DVec3::new(2.6 * outward * cos, radius, 2.6 * outward * sin),
            radius,
        },
        transform: Transform::default(),
        material: 1,
        velocity: glam::DVec3::ZERO,
    }
}

//! Scenes under lamps and skies, and what of a picture is compared.

use std::sync::Arc;

use glam::DVec3;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::render::{Accuracy, Backend, render};
use rayproof::scene::{
    AreaForm, Background, Environment, Geometry, Image, Light, Material, Rgb, Scene, Shape, Sky,
    Texels, Transform,
};
use rayproof::{Frame, Unwatched};

/// A lamp.
pub fn lamp(form: AreaForm, radiance: Rgb) -> Light {
    Light::Area { form, radiance }
}

/// A spherical lamp.
pub fn sphere(center: DVec3, radius: f64) -> AreaForm {
    AreaForm::Sphere { center, radius }
}

/// What one light lights.
pub fn under(light: Light) -> Flat<f32> {
    flatten(&Scene {
        lights: vec![light],
        ..Scene::default()
    })
}

/// A lamp that is a disk.
pub fn disk(center: DVec3, normal: DVec3, radius: f64) -> AreaForm {
    AreaForm::Disk {
        center,
        normal,
        radius,
    }
}

/// A rectangle around a middle, its front towards `right` x `up`.
pub fn rectangle(center: DVec3, right: DVec3, up: DVec3) -> AreaForm {
    AreaForm::Rectangle {
        corner: center - (right + up) / 2.0,
        right,
        up,
    }
}

/// An environment of one colour or two.
pub fn ramp(from: Rgb, to: Rgb) -> Environment {
    Environment {
        sky: Sky::Gradient(Background {
            from,
            to,
            offset: 0.5,
            slope: 0.5,
        }),
        intensity: 1.0,
        turn_degrees: 0.0,
    }
}

/// An environment of an image, its texels given by column and row.
pub fn image(width: u32, height: u32, texel: impl Fn(u32, u32) -> Rgb) -> Environment {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let texels = places.map(|(x, y)| {
        let [r, g, b] = texel(x, y).map(|channel| channel as f32);
        [r, g, b, 1.0]
    });
    Environment {
        sky: Sky::Image(Arc::new(Texels {
            name: "sky".into(),
            width,
            height,
            texels: texels.collect(),
        })),
        intensity: 1.0,
        turn_degrees: 0.0,
    }
}

/// A matt material.
pub fn matt(albedo: Rgb) -> Material {
    Material {
        albedo,
        ..Material::default()
    }
}

/// A shape where it is, in a material.
pub fn shape(geometry: Geometry, material: usize) -> Shape {
    Shape {
        geometry,
        transform: Transform::default(),
        material,
        velocity: DVec3::ZERO,
    }
}

/// A room: floor and two walls, a sphere, all kinds of lamps, and a sky.
pub fn room(size: u32, samples: u32, bounces: u32) -> Scene {
    let plane = |point, normal| Geometry::Plane { point, normal };
    let mut scene = Scene {
        image: Image {
            width: size,
            height: size * 3 / 4,
            ..Image::default()
        },
        materials: vec![
            matt([0.7, 0.7, 0.7]),
            matt([0.7, 0.2, 0.2]),
            matt([0.2, 0.3, 0.7]),
        ],
        shapes: vec![
            shape(plane(DVec3::ZERO, DVec3::Y), 0),
            shape(plane(DVec3::new(-2.0, 0.0, 0.0), DVec3::X), 1),
            shape(plane(DVec3::new(0.0, 0.0, -2.0), DVec3::Z), 2),
            shape(
                Geometry::Sphere {
                    center: DVec3::new(0.2, 0.5, 0.0),
                    radius: 0.5,
                },
                0,
            ),
            shape(
                Geometry::Triangle {
                    vertices: [
                        DVec3::new(1.0, 0.3, 0.0),
                        DVec3::new(1.8, 0.3, 0.2),
                        DVec3::new(1.4, 0.9, -0.4),
                    ],
                },
                1,
            ),
        ],
        lights: vec![
            lamp(sphere(DVec3::new(-1.2, 0.35, 0.3), 0.25), [3.0, 2.0, 1.0]),
            lamp(
                AreaForm::Disk {
                    center: DVec3::new(1.2, 2.0, 0.6),
                    normal: DVec3::new(-0.3, -1.0, -0.2),
                    radius: 0.3,
                },
                [4.0, 4.0, 4.0],
            ),
            lamp(
                AreaForm::Rectangle {
                    corner: DVec3::new(-0.8, 1.2, -1.9),
                    right: DVec3::new(1.0, 0.0, 0.0),
                    up: DVec3::new(0.0, 0.6, 0.1),
                },
                [0.5, 1.5, 1.0],
            ),
        ],
        environment: Some(ramp([0.1, 0.1, 0.1], [0.2, 0.3, 0.5])),
        ..Scene::default()
    };
    scene.camera.eye = DVec3::new(1.5, 1.4, 4.0);
    scene.camera.target = DVec3::new(0.0, 0.6, 0.0);
    scene.integrator.samples = samples;
    scene.integrator.bounces = bounces;
    scene
}

/// The picture of a scene.
pub fn picture(scene: &Scene, backend: &Backend) -> Frame {
    render(scene, backend, Accuracy::Robust, &Unwatched)
        .unwrap()
        .frame
}

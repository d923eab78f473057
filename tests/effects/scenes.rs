//! A small scene that calls for any effects.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{
    AreaForm, Background, Environment, Falloff, Fog, Geometry, Light, Material, Pattern, Scene,
    Shape, Sky, Texels, Texture, Transform,
};

/// The materials that effects change, each with a sphere of its own.
const MIRROR: usize = 1;
const CLEAR: usize = 2;
const COLORED: usize = 3;
const SHINING: usize = 4;

/// A floor, four spheres and a teapot in two lights, from which everything is seen that an effect
/// does; it calls for one ray a pixel.
pub fn plain_scene() -> Scene {
    let colored = |name: &str, albedo| Material {
        name: name.into(),
        albedo,
        ..Material::default()
    };
    let at = |x: f64, y: f64, z: f64, size: f64| Transform {
        linear: DMat3::from_diagonal(DVec3::splat(size)),
        translate: DVec3::new(x, y, z),
    };
    let shape = |geometry, transform, material| Shape {
        geometry,
        transform,
        material,
        velocity: DVec3::ZERO,
    };
    let sphere = Geometry::Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };
    let floor = Geometry::Plane {
        point: DVec3::new(0.0, -0.8, 0.0),
        normal: DVec3::Y,
    };
    let teapot = Geometry::Mesh(Arc::new(build(Builtin::Teapot, 400)));
    let mut scene = Scene {
        background: Background {
            from: [0.2, 0.3, 0.5],
            to: [0.8, 0.8, 0.7],
            offset: 0.5,
            slope: 0.5,
        },
        ambient: [0.1, 0.1, 0.12],
        lights: vec![
            Light::Point {
                position: DVec3::new(1.5, 3.0, 2.0),
                color: [4.0, 3.6, 3.0],
                falloff: Falloff::InverseSquare,
                shadow: false,
            },
            Light::Directional {
                direction: DVec3::new(-1.0, 2.0, 1.0),
                color: [0.4; 3],
                shadow: false,
            },
        ],
        materials: vec![
            Material::default(),
            colored("mirror", [0.7, 0.5, 0.3]),
            colored("clear", [0.3, 0.5, 0.7]),
            colored("colored", [0.9, 0.9, 0.6]),
            colored("shining", [0.5, 0.7, 0.4]),
        ],
        shapes: vec![
            shape(floor, Transform::default(), 0),
            shape(teapot, at(0.9, -0.8, 0.2, 0.3), 0),
            shape(sphere.clone(), at(-0.9, 0.0, -0.4, 0.8), MIRROR),
            shape(sphere.clone(), at(-0.5, -0.4, 0.9, 0.4), CLEAR),
            shape(sphere.clone(), at(0.3, -0.3, 0.8, 0.4), COLORED),
            shape(sphere, at(-0.1, 0.9, 0.0, 0.4), SHINING),
        ],
        ..Scene::default()
    };
    scene.camera.eye = DVec3::new(0.2, 1.0, 4.0);
    scene.camera.target = DVec3::new(0.0, 0.0, 0.0);
    scene.camera.fov_degrees = 45.0;
    scene.with_size(32, 24)
}

/// Has the scene call for an effect of paths, and for no other one if that can be.
pub fn call_for(name: &str, scene: &mut Scene) {
    match name {
        "hard shadows" => {
            for light in &mut scene.lights {
                if let Light::Point { shadow, .. } | Light::Directional { shadow, .. } = light {
                    *shadow = true;
                }
            }
        }
        "soft shadows" => scene.lights.extend([
            Light::Area {
                form: AreaForm::Sphere {
                    center: DVec3::new(0.0, 2.0, 1.0),
                    radius: 0.3,
                },
                radiance: [6.0, 6.0, 5.0],
            },
            Light::Area {
                form: AreaForm::Rectangle {
                    corner: DVec3::new(-2.0, 2.5, -1.0),
                    right: DVec3::X,
                    up: DVec3::Z,
                },
                radiance: [2.0, 3.0, 2.0],
            },
        ]),
        "mirrors" => {
            scene.materials[MIRROR].mirror = [0.6, 0.5, 0.4];
        }
        "glossy reflection" => {
            scene.materials[0].mirror = [0.2; 3];
            scene.materials[0].roughness = 0.3;
        }
        "refraction" => {
            scene.materials[CLEAR].ior = Some(1.5);
            scene.materials[CLEAR].absorption = [0.1, 0.4, 0.8];
        }
        "textures" => scene.materials[COLORED].texture = Some(image_texture()),
        "alpha cut-outs" => {
            scene.materials[COLORED].texture = Some(image_texture());
            scene.materials[COLORED].cutout = true;
        }
        "emission" => scene.materials[SHINING].emission = [0.5, 0.2, 0.1],
        "environment" => {
            scene.environment = Some(Environment {
                sky: Sky::Image(image()),
                intensity: 0.7,
                turn_degrees: 30.0,
            });
        }
        "depth of field" => {
            scene.camera.aperture = 0.2;
            scene.camera.focus = Some(3.5);
        }
        "motion blur" => {
            scene.shapes[1].velocity = DVec3::new(0.3, 0.1, 0.0);
            scene.shapes[2].velocity = DVec3::new(0.0, 0.2, 0.0);
            scene.camera.velocity = DVec3::new(0.02, 0.0, 0.0);
        }
        "fog" => {
            scene.fog = Some(Fog {
                density: 0.1,
                albedo: [0.9, 0.8, 0.8],
            });
        }
        "ambient occlusion" => scene.occlusion = 1.5,
        "indirect light" => scene.integrator.bounces = 2,
        "anti-aliasing" => scene.integrator.samples = 3,
        other => panic!("no cause is known for {other}"),
    }
}

/// Eight by four texels, some of them clear.
fn image() -> Arc<Texels> {
    let texel = |index: u32| {
        let part = |step: u32| f32::from(u8::try_from(index * step % 11).unwrap()) / 10.0;
        let alpha = if index.is_multiple_of(3) { 0.0 } else { 1.0 };
        [part(3), part(5), part(7), alpha]
    };
    Arc::new(Texels {
        name: "made".into(),
        width: 8,
        height: 4,
        texels: (0..32).map(texel).collect(),
    })
}

fn image_texture() -> Texture {
    Texture {
        pattern: Pattern::Image(image()),
        repeat: [2.0, 2.0],
        size: 1.0,
    }
}

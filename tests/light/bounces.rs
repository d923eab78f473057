//! Where light cannot bounce, paths that may see what direct light shows.

use glam::DVec3;
use rayproof::Scene;
use rayproof::render::Backend;
use rayproof::scene::{Background, Falloff, Geometry, Light, Strategy};

use crate::common::assert_same_bits;
use crate::mirrors::mirror;
use crate::noisy::Noisy;
use crate::scenes::{disk, lamp, matt, picture, room, shape, sphere};
use crate::seen::looking_at;

/// A ball alone, under lights of all kinds.
fn lone_ball(has_lamps: bool) -> Scene {
    let ball = Geometry::Sphere {
        center: DVec3::new(0.0, 0.0, -3.0),
        radius: 1.0,
    };
    let mut scene = looking_at(vec![ball], matt([0.9, 0.8, 0.7])).with_size(32, 32);
    scene.background = Background::plain([0.0; 3]);
    scene.camera.fov_degrees = 40.0;
    scene.integrator.samples = 64;
    scene.lights = vec![
        Light::Point {
            position: DVec3::new(2.0, 2.0, 0.0),
            color: [1.0, 0.9, 0.8],
            falloff: Falloff::InverseSquare,
            shadow: true,
        },
        Light::Directional {
            direction: DVec3::new(-1.0, 0.3, 0.1),
            color: [0.1, 0.2, 0.3],
            shadow: true,
        },
    ];
    if has_lamps {
        scene.lights.extend([
            lamp(sphere(DVec3::new(-3.0, 1.0, -1.0), 1.0), [3.0; 3]),
            lamp(
                disk(DVec3::new(1.0, 4.0, -2.0), DVec3::NEG_Y, 1.0),
                [4.0, 2.0, 1.0],
            ),
        ]);
    }
    scene
}

/// From a convex body alone in the dark, a path finds nothing that was not searched for.
#[test]
fn a_lone_ball_is_lit_directly() {
    let cpu = Backend::Cpu(None);
    for has_lamps in [false, true] {
        let mut scene = lone_ball(has_lamps);
        scene.integrator.strategy = Strategy::Lights;
        let direct = picture(&scene, &cpu);
        scene.integrator.bounces = 5;
        assert_same_bits(&direct, &picture(&scene, &cpu));
        // The control: a floor under it throws some light back.
        let floor = Geometry::Plane {
            point: DVec3::NEG_Y * 1.5,
            normal: DVec3::Y,
        };
        scene.shapes.push(shape(floor, 0));
        let indirect = picture(&scene, &cpu);
        scene.integrator.bounces = 0;
        assert!(!indirect.has_bits_of(&picture(&scene, &cpu)));
    }
}

/// With both ways, the light is the same but for the noise.
#[test]
fn a_lone_ball_is_lit_as_much_by_both_ways() {
    let direct = Noisy::of(&lone_ball(true));
    for strategy in [Strategy::Both, Strategy::Surfaces] {
        let mut scene = lone_ball(true);
        scene.integrator.strategy = strategy;
        scene.integrator.bounces = 5;
        assert!(Noisy::of(&scene).agrees(&direct), "{strategy:?}");
        scene.materials[0] = matt([0.8, 0.7, 0.6]);
        assert!(!Noisy::of(&scene).agrees(&direct), "the control");
    }
}

/// What scatters nothing sends no path on, whatever else it does.
#[test]
fn black_does_not_bounce() {
    let cpu = Backend::Cpu(None);
    for strategy in [Strategy::Both, Strategy::Lights, Strategy::Surfaces] {
        let mut scene = room(32, 8, 0);
        scene.integrator.strategy = strategy;
        for (material, reflectance) in scene.materials.iter_mut().zip([0.0, 0.6, 0.3]) {
            *material = mirror(reflectance, reflectance, 0.0);
        }
        // Only in direct light alone does no path end by lot: none that brings all its light.
        scene.integrator.reflections = 1;
        let direct = picture(&scene, &cpu);
        scene.integrator.bounces = 7;
        assert_same_bits(&direct, &picture(&scene, &cpu));
        // The control: a little white.
        scene.materials[0].albedo = [0.01; 3];
        assert!(!direct.has_bits_of(&picture(&scene, &cpu)));
    }
}

//! Matt surfaces: a ball under light from far away, a floor under lamps and light points.

use std::f64::consts::PI;

use glam::DVec3;
use rayproof::Scene;
use rayproof::scene::{Background, Falloff, Geometry, Light};

use crate::scenes::{lamp, matt, sphere};
use crate::seen::{FAR, ROUNDING, looking_at, mean_of};

/// A unit ball that is seen as if from infinitely far, all but its rim's last part.
const DISTANCE: f64 = 1e4;

fn far_ball(phase: f64, size: u32) -> Scene {
    let ball = Geometry::Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };
    let mut scene = looking_at(vec![ball], matt([0.5; 3])).with_size(size, size);
    scene.background = Background::plain([0.0; 3]);
    scene.camera.eye = DVec3::Z * DISTANCE;
    scene.camera.target = DVec3::ZERO;
    scene.camera.fov_degrees = 2.0 * (1.25 / DISTANCE).atan().to_degrees();
    scene.lights = vec![Light::Directional {
        direction: DVec3::new(phase.sin(), 0.0, phase.cos()),
        color: [2.0; 3],
        shadow: true,
    }];
    scene
}

/// Lambert, "Photometria", 1760: of a ball whose light comes from an angle a to the viewer, the
/// integral over its disk is 2/3 (sin a + (pi - a) cos a).
#[test]
fn a_ball_is_as_bright_as_its_phase() {
    for phase in [0.0, 0.5, 1.5, 2.6] {
        let mut scene = far_ball(phase, 48);
        scene.integrator.samples = 16;
        let mean = mean_of(&scene);
        // The picture is 2.5 wide and high.
        let found = mean.color[0] * 2.5 * 2.5;
        let exact = 2.0 / 3.0 * (phase.sin() + (PI - phase) * phase.cos());
        // What is nearer is larger by 1 / DISTANCE, and rays are as much askew. So far away, all
        // roundings of the ball's place, some ten of its distance, count as its radius does.
        let askew = 4.0 / DISTANCE + 16.0 * ROUNDING * DISTANCE;
        let most = FAR * mean.error * 2.5 * 2.5 + askew;
        assert!((found - exact).abs() < most, "{phase}: {found}, {exact}");
        assert!((found - exact * 1.05).abs() > most || phase > 2.0);
    }
}

/// Pixel by pixel: the cosine.
#[test]
fn each_place_of_a_ball_has_its_cosine() {
    let light = DVec3::new(0.48, 0.6, 0.64);
    let center = DVec3::new(0.0, 0.0, -3.0);
    let ball = Geometry::Sphere {
        center,
        radius: 1.0,
    };
    let mut scene = looking_at(vec![ball], matt([0.5; 3])).with_size(40, 40);
    scene.background = Background::plain([0.0; 3]);
    scene.camera.fov_degrees = 40.0;
    scene.lights = vec![Light::Directional {
        direction: light,
        color: [2.0; 3],
        shadow: true,
    }];
    let frame = mean_of(&scene).frame;
    let reach = 20f64.to_radians().tan();
    let (mut lit, mut dark) = (0, 0);
    for (index, color) in frame.color.iter().enumerate() {
        let at = |pixel: usize| (2.0 * pixel as f64 + 1.0) / 40.0 - 1.0;
        let ray = DVec3::new(at(index % 40) * reach, -at(index / 40) * reach, -1.0).normalize();
        let nearest = ray.dot(center);
        let square = 1.0 - (9.0 - nearest * nearest);
        if square < 0.01 {
            continue;
        }
        let cosine = (ray * (nearest - square.sqrt()) - center).dot(light);
        // The normal is off by some roundings of lengths up to 3 by the root.
        let most = 30.0 * ROUNDING / square.sqrt();
        let off = |cosine: f64| (f64::from(color[0]) - cosine.max(0.0)).abs();
        assert!(off(cosine) < most, "{index}: {color:?}, {cosine}");
        assert!(cosine.abs() < 0.01 || off(-cosine) > most, "the control");
        lit += usize::from(cosine > 0.0);
        dark += usize::from(cosine < 0.0);
    }
    assert!(lit > 300 && dark > 50, "{lit}, {dark}");
}

/// A floor of albedo 1/2, seen from above at `x`.
fn floor_at(x: f64) -> Scene {
    let floor = Geometry::Plane {
        point: DVec3::ZERO,
        normal: DVec3::Y,
    };
    let mut scene = looking_at(vec![floor], matt([0.5; 3])).with_size(4, 4);
    scene.background = Background::plain([0.0; 3]);
    scene.camera.eye = DVec3::new(x, 1.0, 0.3);
    scene.camera.target = DVec3::new(x, 0.0, 0.0);
    scene
}

/// The places are off by the sine of half the angle of view, and by roundings of their distance:
/// in parts of the light, by some times as much.
const OFF: f64 = 8.0 * 1e-5 + 64.0 * ROUNDING;

/// L (r / d)^2 cos, at all distances at which the ball is above the horizon.
#[test]
fn a_spherical_lamp_lights_a_floor() {
    let (height, radius) = (1.8, 0.6);
    for x in [0.0, 0.5, 2.0, 7.0] {
        let mut scene = floor_at(x);
        scene.lights = vec![lamp(sphere(DVec3::Y * height, radius), [3.0; 3])];
        scene.integrator.samples = 256;
        let mean = mean_of(&scene);
        let square = x * x + height * height;
        let exact = 0.5 * 3.0 * radius * radius / square * (height / square.sqrt());
        let most = FAR * mean.error + OFF * exact;
        let off = |exact: f64| (mean.color[0] - exact).abs();
        assert!(off(exact) < most, "{x}: {:?}, {exact}", mean.color);
        // The control: a floor that is by a part in 50 farther away.
        assert!(off(exact * 0.98 * 0.98) > most, "{x}");
    }
}

/// a c cos / d^2.
#[test]
fn a_point_lights_a_floor_by_its_distance() {
    for shadow in [true, false] {
        for x in [0.0, 0.5, 2.0, 40.0] {
            let mut scene = floor_at(x);
            scene.lights = vec![Light::Point {
                position: DVec3::Y * 1.5,
                color: [3.0; 3],
                falloff: Falloff::InverseSquare,
                shadow,
            }];
            let found = mean_of(&scene).color[0];
            let square: f64 = x * x + 1.5 * 1.5;
            let exact = 0.5 * 3.0 * 1.5 / square.sqrt() / square;
            assert!((found / exact - 1.0).abs() < OFF, "{x}: {found}, {exact}");
            assert!((found / exact * square.sqrt() - 1.0).abs() > OFF);
        }
    }
}

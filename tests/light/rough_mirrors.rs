//! Rough mirrors under lamps and skies: all ways find the same light, and it is that of the
//! integral.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use rayproof::Scene;
use rayproof::flatten::flatten;
use rayproof::kernel::glossy::energy_of;
use rayproof::scene::{AreaForm, Environment, Geometry, Light, Material, Strategy};

use crate::common::BRUTE_FORCE;
use crate::mirrors::{BETWEEN, mirror, plane_at, textbook, thrown_back};
use crate::noisy::Noisy;
use crate::scenes::{image, lamp, matt, ramp, rectangle, shape, sphere};
use crate::seen::{FAR, assert_backends_agree, by_height, looking_at, mean_of};

const WAYS: [Strategy; 3] = [Strategy::Both, Strategy::Lights, Strategy::Surfaces];

/// A floor and balls that mirror roughly, and a matt wall.
fn mirrors() -> Scene {
    let ball = |x: f64, radius: f64| Geometry::Sphere {
        center: DVec3::new(x, radius, 0.0),
        radius,
    };
    let plane = |point, normal| Geometry::Plane { point, normal };
    let mut scene = Scene {
        materials: vec![
            mirror(0.5, 0.4, 0.6),
            mirror(0.9, 0.3, 0.0),
            mirror(0.1, 0.7, 0.8),
            matt([0.6, 0.5, 0.4]),
        ],
        shapes: vec![
            shape(plane(DVec3::ZERO, DVec3::Y), 0),
            shape(plane(DVec3::NEG_Z * 2.0, DVec3::Z), 3),
            shape(ball(-0.7, 0.6), 1),
            shape(ball(0.7, 0.5), 2),
        ],
        ..Scene::default()
    }
    .with_size(32, 24);
    scene.camera.eye = DVec3::new(0.3, 1.6, 4.0);
    scene.camera.target = DVec3::new(0.0, 0.5, 0.0);
    scene.integrator.samples = 256;
    scene
}

/// The same under lamps, and under a sky with a large sun.
fn lit() -> [Scene; 2] {
    let mut lamps = mirrors();
    lamps.lights = vec![
        lamp(sphere(DVec3::new(-1.5, 1.8, 1.0), 0.5), [3.0, 2.0, 1.0]),
        lamp(
            rectangle(DVec3::new(1.0, 2.4, 0.5), DVec3::X, DVec3::Z),
            [2.0, 2.5, 3.0],
        ),
    ];
    let mut sky = mirrors();
    // The wall would keep off a half.
    sky.shapes.remove(1);
    sky.environment = Some(image(16, 8, |x, y| match (x, y) {
        (10, 2) => [20.0, 18.0, 15.0],
        (_, y) => [0.2, 0.3, 0.1 * f64::from(8 - y)],
    }));
    [lamps, sky]
}

#[test]
fn all_ways_find_the_same_light() {
    for bounces in [0, 2] {
        for mut scene in lit() {
            scene.integrator.bounces = bounces;
            let [both, lights, surfaces] = WAYS.map(|strategy| {
                scene.integrator.strategy = strategy;
                Noisy::of(&scene)
            });
            println!("{} {} {}", both.error, lights.error, surfaces.error);
            assert!(both.agrees(&lights), "{bounces}");
            assert!(both.agrees(&surfaces), "{bounces}");
            assert!(lights.agrees(&surfaces), "{bounces}");
            assert!(both.error <= lights.error.max(surfaces.error));
            // The control: all throws back a little less.
            let mut dimmer = scene.clone();
            for material in &mut dimmer.materials {
                material.mirror = material.mirror.map(|part| part * 0.9);
                material.albedo = material.albedo.map(|part| part * 0.9);
            }
            dimmer.integrator.strategy = Strategy::Both;
            assert!(!Noisy::of(&dimmer).agrees(&both), "the control");
        }
    }
}

#[test]
fn both_backends_find_the_same_light() {
    for mut scene in lit() {
        scene.integrator.samples = 4;
        for strategy in WAYS {
            scene.integrator.strategy = strategy;
            for bounces in [0, 2] {
                scene.integrator.bounces = bounces;
                assert_backends_agree(&scene, &[BRUTE_FORCE]);
            }
        }
        // The control: both ways are not one of them.
        let [both, lights, surfaces] = WAYS.map(|strategy| {
            scene.integrator.strategy = strategy;
            mean_of(&scene).frame
        });
        assert!(!both.has_bits_of(&lights) && !both.has_bits_of(&surfaces));
    }
}

/// A place of a plane, seen along -z at a cosine.
struct Place {
    material: Material,
    cosine: f64,
    bounces: u32,
}

impl Place {
    fn scene(&self) -> Scene {
        let shapes = vec![plane_at(self.cosine)];
        let mut scene = looking_at(shapes, self.material.clone()).with_size(8, 8);
        scene.background = rayproof::scene::Background::plain([0.0; 3]);
        scene.integrator.samples = 256;
        scene.integrator.bounces = self.bounces;
        scene
    }

    /// What the place sends to the viewer of light of radiance 1 from a direction, by solid
    /// angle: its mirror's part and, where paths may bounce or are not asked to, its matt part.
    fn response(&self, scene: &Scene) -> impl Fn(DVec3) -> f64 {
        let normal = DVec3::new(0.0, (1.0 - self.cosine * self.cosine).sqrt(), self.cosine);
        let width = self.material.roughness * self.material.roughness;
        let flat = flatten::<f32>(scene);
        let energy = f64::from(energy_of(&flat, 0, width as f32, self.cosine as f32));
        let part = thrown_back(self.material.mirror[0], self.cosine);
        let even = (1.0 - part) * self.material.albedo[0] / PI;
        move |light: DVec3| {
            let lit = light.dot(normal);
            if lit <= 0.0 {
                return 0.0;
            }
            (part * textbook(DVec3::Z, light, normal, width) / energy + even) * lit
        }
    }
}

/// Matt and mirror, by directions that are searched for alone and by both ways.
fn places() -> Vec<Place> {
    let mut places = Vec::new();
    for roughness in [0.4, 0.6, 1.0] {
        for cosine in [0.4, 0.9] {
            for (albedo, bounces) in [(0.0, 0), (0.5, 0), (0.5, 1)] {
                places.push(Place {
                    material: mirror(0.4, roughness, albedo),
                    cosine,
                    bounces,
                });
            }
        }
    }
    places
}

/// Fails unless the picture is as bright as that, by each way.
fn assert_seen(place: &Place, scene: &Scene, expected: f64, quadrature: f64) {
    for strategy in WAYS {
        let mut scene = scene.clone();
        scene.integrator.strategy = strategy;
        let mean = mean_of(&scene);
        let found = mean.color[0];
        let most = FAR * mean.error + (BETWEEN + quadrature) * expected;
        let Place {
            material, bounces, ..
        } = place;
        let here = format!(
            "{strategy:?} {} {} {bounces}: {found} +- {most}, {expected}",
            material.roughness, place.cosine
        );
        assert!((found - expected).abs() < most, "{here}");
        if strategy == Strategy::Both {
            // The control: a part in 20 more.
            assert!((found - 1.05 * expected).abs() > most, "{here}");
        }
    }
}

/// The lamp stands where a smooth mirror would show it. The steps of the integral are a part in
/// 200 of a lamp that is no wider than the lobe: off by the square of that, some times.
#[test]
fn a_lamp_is_seen_as_the_integral_has_it() {
    for place in places() {
        let mut scene = place.scene();
        let at = DVec3::new(0.0, 0.0, -3.0);
        let normal = DVec3::new(0.0, (1.0 - place.cosine.powi(2)).sqrt(), place.cosine);
        let towards = normal * (2.0 * place.cosine) - DVec3::Z;
        let center = at + towards * 2.0;
        let right = DVec3::X * 1.2;
        let up = towards.cross(right).normalize() * -0.9;
        let mut form = rectangle(center, right, up);
        if right.cross(up).dot(towards) > 0.0 {
            form = rectangle(center, right, -up);
        }
        let AreaForm::Rectangle { corner, right, up } = form else {
            unreachable!()
        };
        scene.lights = vec![Light::Area {
            form,
            radiance: [1.0; 3],
        }];
        let response = place.response(&scene);
        let front = right.cross(up);
        let steps = 200;
        let part = |step: i32| (f64::from(step) + 0.5) / f64::from(steps);
        let mut sum = 0.0;
        for i in 0..steps {
            for j in 0..steps {
                let way = corner + right * part(i) + up * part(j) - at;
                let light = way.normalize();
                let angle = -front.dot(light) / way.length_squared();
                sum += response(light) * angle / f64::from(steps * steps);
            }
        }
        assert_seen(&place, &scene, sum, 1e-4);
    }
}

/// A sky that gets brighter with height. The steps are 1/400 of a right angle, a part in 40 of the
/// narrowest lobe, which is smooth: off by a part in 1000 at most.
#[test]
fn a_sky_is_seen_as_the_integral_has_it() {
    for place in places() {
        let mut scene = place.scene();
        scene.environment = Some(ramp([0.2; 3], [1.0; 3]));
        let response = place.response(&scene);
        let steps = 400;
        let mut sum = 0.0;
        for i in 0..2 * steps {
            // By heights: parts of the sphere are as large.
            let height = (f64::from(i) + 0.5) / f64::from(steps) - 1.0;
            let radius = (1.0 - height * height).sqrt();
            for j in 0..4 * steps {
                let turn = (f64::from(j) + 0.5) / f64::from(4 * steps) * TAU;
                let light = DVec3::new(radius * turn.cos(), height, radius * turn.sin());
                sum += response(light) * (0.6 + 0.4 * height);
            }
        }
        let angle = 2.0 * TAU / f64::from(2 * steps * 4 * steps);
        assert_seen(&place, &scene, sum * angle, 1e-3);
    }
}

/// What a sky of the same radiance everywhere and a background have in common: all ways see a
/// ball of both lobes vanish.
#[test]
fn a_ball_of_both_lobes_vanishes() {
    let ball = Geometry::Sphere {
        center: DVec3::new(0.0, 0.0, -3.0),
        radius: 1.0,
    };
    let even: Environment = ramp([1.0; 3], [1.0; 3]);
    // Where light is searched for alone, narrower lobes are met too rarely to be sure.
    for roughness in [0.4, 0.6, 1.0] {
        for strategy in WAYS {
            let seen = |albedo| {
                let material = mirror(0.3, roughness, albedo);
                let mut scene = looking_at(vec![ball.clone()], material).with_size(16, 16);
                scene.background = by_height();
                scene.environment = Some(even.clone());
                scene.camera.fov_degrees = 36.0;
                scene.integrator.samples = 256;
                scene.integrator.bounces = 1;
                scene.integrator.strategy = strategy;
                let mean = mean_of(&scene);
                let most = FAR * mean.error + BETWEEN;
                (mean.color[0] - 1.0, most)
            };
            let (off, most) = seen(1.0);
            assert!(off.abs() < most, "{roughness} {strategy:?}: {off}");
            let (off, most) = seen(0.7);
            assert!(off.abs() > most, "the control: {off}, {most}");
        }
    }
}

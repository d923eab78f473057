//! Fog against the integrals that it stands for.

use glam::DVec3;
use rayproof::kernel::fog::even_direction;
use rayproof::kernel::hit::Surface;
use rayproof::kernel::integrator::Look;
use rayproof::kernel::vector::{Vec3, dot_product, unit_vector, vec3};
use rayproof::scene::{Background, Falloff, Fog, Geometry, Light, Material, Rgb, Shape, Transform};
use rayproof::{Scene, Unwatched};

use crate::common::{assert_same_bits, on_cpu, on_gpu};

/// Samples of the pixel. The first 2^k numbers of a pair of dimensions are one in each 2^-k of
/// the range, so a mean of a function of one of them is off by its variation over so many at
/// most (Koksma).
const SAMPLES: u32 = 4096;

/// A matt colour that shines.
fn glowing(albedo: Rgb, emission: Rgb) -> Material {
    Material {
        albedo,
        emission,
        ..Material::default()
    }
}

fn shape(geometry: Geometry, material: usize) -> Shape {
    Shape {
        geometry,
        transform: Transform::default(),
        material,
        velocity: DVec3::ZERO,
    }
}

/// A wall across the line of sight.
fn wall(distance: f64) -> Geometry {
    Geometry::Plane {
        point: DVec3::new(0.0, 0.0, -distance),
        normal: DVec3::Z,
    }
}

/// One pixel, so narrow that all its rays are along -z but for 1e-4 of their length.
fn line_of_sight(fog: Option<Fog>, material: Material, distance: f64) -> Scene {
    let mut scene = Scene {
        fog,
        materials: vec![material],
        shapes: vec![shape(wall(distance), 0)],
        ..Scene::default()
    }
    .with_size(1, 1);
    scene.camera.fov_degrees = 0.01;
    scene.integrator.samples = SAMPLES;
    scene
}

fn pixel(scene: &Scene) -> Rgb {
    on_cpu(scene).color[0].map(f64::from)
}

/// A sum of so many f32 and its quotient are off by a half rounding each.
fn roundings(mean: f64) -> f64 {
    mean * f64::from(SAMPLES + 16) / f64::from(1 << 24)
}

#[test]
fn what_comes_through_falls_as_the_power_of_the_way() {
    let glow = glowing([0.0; 3], [1.0; 3]);
    for (density, distance) in [(0.25f64, 1.0), (0.25, 4.0), (1.0, 3.0), (3.0, 0.01)] {
        let fog = |density| {
            Some(Fog {
                density,
                albedo: [0.0; 3],
            })
        };
        let seen = pixel(&line_of_sight(fog(density), glow.clone(), distance))[0];
        let expected = (-density * distance).exp();
        // A step of height 1, and the pixel's rays.
        let most = 1.0 / f64::from(SAMPLES) + roundings(1.0) + 1e-8;
        assert!(
            (seen - expected).abs() <= most,
            "{density}, {distance}: {seen}"
        );
        // The control: fog that is denser by a tenth.
        let other = pixel(&line_of_sight(fog(1.1 * density), glow.clone(), distance))[0];
        assert!(
            (other - expected).abs() > most,
            "{density}, {distance}: {other}"
        );
    }
}

#[test]
fn nothing_is_seen_through_fog_without_end() {
    let mut scene = line_of_sight(None, Material::default(), 1.0);
    scene.shapes.clear();
    scene.background = Background::plain([1.0; 3]);
    assert_eq!(pixel(&scene), [1.0; 3]);
    scene.fog = Some(Fog {
        density: 1e-3,
        albedo: [0.0; 3],
    });
    assert_eq!(pixel(&scene), [0.0; 3]);
}

/// The integral over the way by Simpson's rule, of twice so many parts.
fn integral(end: f64, parts: u32, value: impl Fn(f64) -> f64) -> f64 {
    let step = end / f64::from(2 * parts);
    let sum: f64 = (0..=2 * parts)
        .map(|i| {
            let weight = match i {
                _ if i == 0 || i == 2 * parts => 1.0,
                _ if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            weight * value(f64::from(i) * step)
        })
        .sum();
    sum * step / 3.0
}

#[test]
fn light_is_scattered_once_as_the_integral_says() {
    const DISTANCE: f64 = 4.0;
    let light = DVec3::new(0.7, 0.4, -2.5);
    let color: Rgb = [1.0, 2.0, 0.5];
    let (density, albedo): (f64, Rgb) = (0.3, [0.9, 0.5, 0.2]);
    let mut scene = line_of_sight(
        Some(Fog { density, albedo }),
        glowing([0.0; 3], [0.0; 3]),
        DISTANCE,
    );
    scene.lights = vec![Light::Point {
        position: light,
        color,
        falloff: Falloff::InverseSquare,
        shadow: true,
    }];
    let found = pixel(&scene);
    let to_light = |s: f64| (light - DVec3::new(0.0, 0.0, -s)).length();
    // Of what comes to a place, pi color / d^2, a part of 1 / (4 pi) goes each way.
    let scattered = |s: f64, rate: f64| (-rate * to_light(s)).exp() / (4.0 * to_light(s).powi(2));
    let whole = |rate: f64| {
        integral(DISTANCE, 20_000, |s| {
            density * (-density * s).exp() * scattered(s, rate)
        })
    };
    let expected = whole(density);
    // It rises to the point nearest to the light, falls, and is 0 from the wall on.
    let largest = (0..=4000)
        .map(|i| scattered(DISTANCE * f64::from(i) / 4000.0, density))
        .fold(0.0, f64::max);
    let most = 2.0 * largest / f64::from(SAMPLES) + roundings(expected);
    for channel in 0..3 {
        let factor = albedo[channel] * color[channel];
        let off = (found[channel] - factor * expected).abs();
        assert!(off <= factor * most, "{channel}: {found:?}, {expected}");
        // The control: light that loses nothing on its way to the place.
        let off = (found[channel] - factor * whole(0.0)).abs();
        assert!(off > factor * most);
    }
}

#[test]
fn a_shadow_falls_through_fog() {
    let mut scene = line_of_sight(
        Some(Fog {
            density: 0.3,
            albedo: [1.0; 3],
        }),
        glowing([0.0; 3], [0.0; 3]),
        4.0,
    );
    scene.lights = vec![Light::Point {
        position: DVec3::new(2.0, 0.0, -2.0),
        color: [1.0; 3],
        falloff: Falloff::InverseSquare,
        shadow: true,
    }];
    assert!(pixel(&scene)[0] > 0.0);
    // Something between the line of sight and the light, all along.
    scene.shapes.push(shape(
        Geometry::Plane {
            point: DVec3::X,
            normal: DVec3::X,
        },
        0,
    ));
    assert_eq!(pixel(&scene), [0.0; 3]);
}

/// In a ball that shines with radiance 1 and is black, fog that loses nothing looks as bright
/// everywhere: each path brings 1, unless it is scattered too often.
#[test]
fn fog_that_loses_nothing_is_not_seen_in_a_furnace() {
    let furnace = |albedo: f64| {
        let mut scene = Scene {
            fog: Some(Fog {
                density: 0.5,
                albedo: [albedo; 3],
            }),
            materials: vec![glowing([0.0; 3], [1.0; 3])],
            shapes: vec![shape(
                Geometry::Sphere {
                    center: DVec3::new(0.2, 0.1, 0.0),
                    radius: 1.0,
                },
                0,
            )],
            ..Scene::default()
        }
        .with_size(32, 32);
        scene.integrator.samples = 16;
        scene.integrator.bounces = 64;
        on_cpu(&scene)
    };
    // A way within is 2 at most. A path that is lost is scattered 65 times on it: of 16,384
    // paths none.
    let lost = (1.0 - (-0.5f64 * 2.0).exp()).powi(65);
    assert!(lost * 16_384.0 < 1e-8);
    let frame = furnace(1.0);
    assert!(frame.color.iter().all(|color| *color == [1.0; 3]));
    let dim = furnace(0.9);
    assert!(dim.color.iter().any(|color| color[0] < 1.0), "the control");
}

/// Parts of the sphere get as many directions as their area says, to within the cells of the
/// grid of pairs that their edge goes through.
#[test]
fn directions_in_fog_are_spread_evenly() {
    const SIDE: u32 = 512;
    let at = |i: u32| (i as f32 + 0.5) / SIDE as f32;
    let in_fog = Look {
        is_fog: true,
        ..Look::default()
    };
    let surface = Surface {
        normal: vec3(0.0, 0.0, 1.0),
        ..Surface::default()
    };
    let part = |look: &Look, axis: Vec3<f32>, least: f32| {
        let pairs = (0..SIDE * SIDE).map(|i| [at(i % SIDE), at(i / SIDE)]);
        let directions = pairs.map(|pair| even_direction(&surface, look, pair));
        let inside = directions.filter(|direction| dot_product(axis, *direction) >= least);
        inside.count() as f64 / f64::from(SIDE * SIDE)
    };
    for axis in [
        vec3(0.0, 0.0, 1.0),
        vec3(0.0, 0.0, -1.0),
        vec3(1.0, 0.0, 0.0),
        unit_vector(vec3(-1.0, 2.0, 1.0)),
    ] {
        for least in [-0.5, 0.0, 0.5, 0.9f32] {
            let expected = f64::from(1.0 - least) / 2.0;
            // A curve that crosses each column and each row at most twice.
            let most = 4.0 / f64::from(SIDE);
            let found = part(&in_fog, axis, least);
            assert!(
                (found - expected).abs() <= most,
                "{axis:?}, {least}: {found}"
            );
            let surface = part(&Look::default(), axis, least);
            let is_equal = (surface - expected).abs() <= most;
            assert!(
                !is_equal || least == 0.0 || axis.z == 0.0,
                "the control: {least}"
            );
        }
    }
    for i in 0..SIDE * SIDE {
        let direction = even_direction(&surface, &in_fog, [at(i % SIDE), at(i / SIDE)]);
        // Three products, of numbers that are off by two roundings each.
        let square = dot_product(direction, direction);
        assert!((square - 1.0).abs() <= 8.0 * f32::EPSILON, "{square}");
    }
}

/// Fog between shapes, under lights of all kinds without size.
pub fn foggy(samples: u32) -> Scene {
    let mut scene = Scene {
        fog: Some(Fog {
            density: 0.15,
            albedo: [0.9, 0.8, 0.7],
        }),
        ambient: [0.05; 3],
        occlusion: 1.0,
        materials: vec![
            glowing([0.8, 0.3, 0.2], [0.0; 3]),
            glowing([0.1; 3], [3.0, 3.0, 1.0]),
        ],
        shapes: vec![
            shape(
                Geometry::Sphere {
                    center: DVec3::new(-1.0, 0.0, -5.0),
                    radius: 1.0,
                },
                0,
            ),
            shape(
                Geometry::Sphere {
                    center: DVec3::new(1.2, -0.5, -4.0),
                    radius: 0.5,
                },
                1,
            ),
            shape(
                Geometry::Plane {
                    point: DVec3::NEG_Y,
                    normal: DVec3::Y,
                },
                0,
            ),
        ],
        lights: vec![
            Light::Point {
                position: DVec3::new(1.0, 2.0, -4.0),
                color: [8.0, 7.0, 5.0],
                falloff: Falloff::InverseSquare,
                shadow: true,
            },
            Light::Directional {
                direction: DVec3::Y,
                color: [1.0; 3],
                shadow: true,
            },
        ],
        ..Scene::default()
    }
    .with_size(64, 48);
    scene.integrator.samples = samples;
    scene.integrator.bounces = 3;
    scene
}

#[test]
fn fog_has_the_same_bits_on_both_sides() {
    let scene = foggy(8);
    assert_same_bits(&on_cpu(&scene), &on_gpu(&scene));
    let clear = Scene { fog: None, ..scene };
    let effects = |scene: &Scene| {
        let backend = rayproof::Backend::Cpu(None);
        let settings = crate::common::BRUTE_FORCE;
        let rendering = rayproof::render(scene, &backend, settings, &Unwatched).unwrap();
        rendering.stats.effects
    };
    assert!(!effects(&clear).contains(&"fog"), "the control");
    assert!(effects(&foggy(1)).contains(&"fog"));
}

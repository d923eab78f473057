//! Mirrors: none of the light is lost, and images are where geometry has them.

use std::f64::consts::PI;

use glam::DVec3;
use rayproof::flatten::flatten;
use rayproof::kernel::glossy::energy_of;
use rayproof::scene::{Background, Falloff, Geometry, Light, Material, Shape, Transform};
use rayproof::{Backend, Scene, Unwatched};

use crate::common::{BRUTE_FORCE, assert_same_bits, compare, gpu};
use crate::seen::{FAR, ROUNDING, assert_paths_agree, by_height, looking_at, mean_of};

/// What is between two numbers of the table of energies is off by so much of it at most.
pub const BETWEEN: f64 = 1.0 / 2048.0;

pub fn mirror(reflectance: f64, roughness: f64, albedo: f64) -> Material {
    Material {
        albedo: [albedo; 3],
        mirror: [reflectance; 3],
        roughness,
        ..Material::default()
    }
}

/// A plane that is seen at this cosine.
pub fn plane_at(cosine: f64) -> Geometry {
    Geometry::Plane {
        point: DVec3::new(0.0, 0.0, -3.0),
        normal: DVec3::new(0.0, (1.0 - cosine * cosine).sqrt(), cosine),
    }
}

/// What a mirror of `reflectance` throws back: Schlick.
pub fn thrown_back(reflectance: f64, cosine: f64) -> f64 {
    reflectance + (1.0 - reflectance) * (1.0 - cosine).powi(5)
}

const ROUGHNESSES: [f64; 6] = [0.0, 0.02, 0.3, 0.5, 0.7, 1.0];
const COSINES: [f64; 4] = [0.05, 0.3, 0.7, 1.0];

/// In light of 1 from everywhere, a perfect mirror looks like that light, however rough.
#[test]
fn a_perfect_mirror_loses_nothing() {
    for roughness in ROUGHNESSES {
        for cosine in COSINES {
            let seen = |reflectance| {
                let material = mirror(reflectance, roughness, 0.0);
                let mut scene = looking_at(vec![plane_at(cosine)], material).with_size(16, 16);
                scene.integrator.samples = 256;
                let mean = mean_of(&scene);
                (mean.color[0], FAR * mean.error + BETWEEN)
            };
            let (mean, most) = seen(1.0);
            assert!((mean - 1.0).abs() < most, "{roughness}, {cosine}: {mean}");
            // The control: a mirror that takes away a little.
            let (mean, most) = seen(0.95);
            let lacks = 1.0 - thrown_back(0.95, cosine);
            assert!(
                (mean - 1.0).abs() > most || lacks < 2.0 * most,
                "{roughness}, {cosine}"
            );
        }
    }
}

/// The same of all angles at once: a ball that is seen as a whole.
#[test]
fn a_rough_ball_vanishes_in_even_light() {
    for roughness in [0.1, 0.4, 1.0] {
        let ball = Geometry::Sphere {
            center: DVec3::new(0.0, 0.0, -3.0),
            radius: 1.0,
        };
        let material = mirror(1.0, roughness, 0.0);
        let mut scene = looking_at(vec![ball], material).with_size(24, 24);
        scene.camera.fov_degrees = 40.0;
        scene.integrator.samples = 64;
        let mean = mean_of(&scene);
        let off = (mean.color[0] - 1.0).abs();
        assert!(off < FAR * mean.error + BETWEEN, "{roughness}: {off}");
    }
}

/// What the mirror leaves meets the albedo.
#[test]
fn both_lobes_share_the_light() {
    for (reflectance, albedo) in [(0.04, 1.0), (0.3, 1.0), (0.3, 0.5), (0.9, 0.5)] {
        for roughness in [0.0, 0.3, 1.0] {
            for cosine in [0.1, 0.6] {
                let material = mirror(reflectance, roughness, albedo);
                let mut scene = looking_at(vec![plane_at(cosine)], material).with_size(16, 16);
                scene.integrator.samples = 256;
                scene.integrator.bounces = 1;
                let mean = mean_of(&scene);
                let part = thrown_back(reflectance, cosine);
                let expected = part + (1.0 - part) * albedo;
                let off = (mean.color[0] - expected).abs();
                assert!(
                    off < FAR * mean.error + BETWEEN,
                    "{material:?}: {off}",
                    material = scene.materials[0]
                );
            }
        }
    }
}

/// The highlight of a light without size is the response of the microfacet mirror, as a
/// textbook writes it.
#[test]
fn highlights_are_as_the_textbook_has_them() {
    let mut highest: f64 = 0.0;
    for roughness in [0.3, 0.5, 1.0] {
        for cosine in [0.3, 0.9] {
            for at in [[0.0, 2.0, 1.0], [1.0, 3.0, -1.0], [-2.0, 2.5, -2.5]] {
                let material = mirror(0.6, roughness, 0.0);
                let mut scene = looking_at(vec![plane_at(cosine)], material);
                scene.background = Background::plain([0.0; 3]);
                scene.lights = vec![Light::Point {
                    position: DVec3::from_array(at),
                    color: [1.0; 3],
                    falloff: Falloff::None,
                    shadow: false,
                }];
                let found = mean_of(&scene).color[0];
                let normal = DVec3::new(0.0, (1.0f64 - cosine * cosine).sqrt(), cosine);
                let light = (DVec3::from_array(at) - DVec3::new(0.0, 0.0, -3.0)).normalize();
                let width = roughness * roughness;
                let flat = flatten::<f32>(&scene);
                let energy = f64::from(energy_of(&flat, 0, width as f32, cosine as f32));
                let response = textbook(DVec3::Z, light, normal, width) / energy;
                let lit = light.dot(normal);
                let expected = thrown_back(0.6, cosine) * PI * response * lit;
                highest = highest.max(expected);
                // Directions are off by some roundings, which are more slopes the narrower the
                // lobe is, by the fourth power of which it falls.
                let most = (64.0 + 32.0 / width) * ROUNDING * expected;
                assert!(
                    (found - expected).abs() < most,
                    "{roughness} {cosine} {at:?}: {found} {expected}"
                );
            }
        }
    }
    assert!(highest > 1.0, "{highest}");
}

/// D G2 / (4 cos cos), with a masking and shadowing that go by height (Heitz 2014).
pub fn textbook(view: DVec3, light: DVec3, normal: DVec3, width: f64) -> f64 {
    let half = (view + light).normalize();
    let [seen, lit, tilt] = [view, light, half].map(|v| v.dot(normal));
    let square = width * width;
    let density = square / (PI * (tilt * tilt * (square - 1.0) + 1.0).powi(2));
    let hidden = |c: f64| ((1.0 + square * (1.0 - c * c) / (c * c)).sqrt() - 1.0) / 2.0;
    density / (1.0 + hidden(seen) + hidden(lit)) / (4.0 * seen * lit)
}

/// A ball that mirrors shows each direction where a ray would be thrown to.
#[test]
fn a_mirror_shows_what_geometry_says() {
    let ball = Geometry::Sphere {
        center: DVec3::new(0.0, 0.0, -3.0),
        radius: 1.0,
    };
    let mut scene = looking_at(vec![ball], mirror(1.0, 0.0, 0.0)).with_size(32, 32);
    scene.background = by_height();
    scene.camera.fov_degrees = 36.0;
    let frame = mean_of(&scene).frame;
    let reach = 18f64.to_radians().tan();
    let (mut seen, mut unmirrored) = (0, 0);
    for (index, color) in frame.color.iter().enumerate() {
        let at = |pixel: usize| (2.0 * pixel as f64 + 1.0) / 32.0 - 1.0;
        let [x, y] = [at(index % 32), -at(index / 32)];
        let ray = DVec3::new(x * reach, y * reach, -1.0).normalize();
        let nearest = -3.0 * ray.z;
        let square = 1.0 - (9.0 - nearest * nearest);
        if square < 0.01 {
            continue;
        }
        let normal = ray * (nearest - square.sqrt()) + 3.0 * DVec3::Z;
        let thrown = ray - normal * (2.0 * ray.dot(normal));
        let off = |height: f64| (f64::from(color[0]) - (1.0 + height) / 2.0).abs();
        // The normal is off by some roundings of lengths up to 3 by the root, which is 1/10
        // at least; mirrored, by twice as much.
        let most = 2.0 * 30.0 * ROUNDING / square.sqrt();
        assert!(off(thrown.y) < most, "{x}, {y}: {color:?}, {thrown}");
        seen += 1;
        unmirrored += usize::from(off(ray.y) > most);
    }
    assert!(seen > 200 && unmirrored > seen - 40, "{seen}, {unmirrored}");
}

/// A path is mirrored as often as it may be, and no more often; smooth mirrors take no light
/// from what is searched for.
#[test]
fn reflections_are_counted() {
    // Between two mirrors, then out.
    let wall = |x: f64, normal: f64| Geometry::Disk {
        center: DVec3::new(x, 0.0, -2.0),
        normal: DVec3::new(normal, 0.0, 0.0),
        radius: 2.0,
    };
    let mut scene = looking_at(
        vec![wall(-0.5, 1.0), wall(0.5, -1.0)],
        mirror(0.5, 0.0, 0.0),
    );
    scene.camera.target = DVec3::new(1.0, 0.0, -1.0);
    // It goes as far to the side as ahead, and meets a wall at every whole number.
    let cosine = 0.5f64.sqrt();
    let met = 4;
    let expected = thrown_back(0.5, cosine).powi(met);
    for (reflections, expected) in [(8, expected), (4, expected), (3, 0.0), (0, 0.0)] {
        scene.integrator.reflections = reflections;
        let found = mean_of(&scene).color[0];
        assert!(
            (found - expected).abs() < 64.0 * ROUNDING,
            "{reflections}: {found}, {expected}"
        );
    }
}

/// Mirrors, smooth and rough, coloured, one beside the other, with lights of both kinds.
fn all_sorts() -> Scene {
    let ball = |x: f64, y: f64, material| Shape {
        geometry: Geometry::Sphere {
            center: DVec3::new(x, y, -4.0),
            radius: 0.6,
        },
        transform: Transform::default(),
        material,
        velocity: DVec3::ZERO,
    };
    let floor = Shape {
        geometry: plane_at(0.3),
        ..ball(0.0, 0.0, 0)
    };
    let mut scene = Scene {
        background: by_height(),
        materials: vec![
            mirror(0.04, 0.4, 0.6),
            mirror(0.9, 0.0, 0.0),
            mirror(0.7, 0.02, 0.3),
            mirror(1.0, 1.0, 0.0),
        ],
        shapes: vec![
            floor,
            ball(-1.0, 0.7, 1),
            ball(0.3, 1.0, 2),
            ball(1.5, 0.8, 3),
        ],
        lights: vec![
            Light::Point {
                position: DVec3::new(1.0, 3.0, 0.0),
                color: [1.0, 0.9, 0.8],
                falloff: Falloff::None,
                shadow: true,
            },
            Light::Directional {
                direction: DVec3::new(-1.0, 1.0, 1.0),
                color: [0.3, 0.4, 0.5],
                shadow: true,
            },
        ],
        ..Scene::default()
    }
    .with_size(48, 32);
    scene.materials[2].mirror = [0.9, 0.6, 0.0];
    scene
}

#[test]
fn both_backends_show_the_same_mirrors() {
    assert_paths_agree(&all_sorts());
    // The control: another roughness is seen.
    let mut other = all_sorts();
    other.materials[3].roughness = 0.999;
    let [one, two] = [all_sorts(), other].map(|scene| mean_of(&scene).frame);
    assert!(!compare(&one, &two).pass);
}

/// With mirrors and clear bodies in the shader that no shape is of, the picture is the same in
/// every bit.
#[test]
fn what_is_not_called_for_changes_nothing() {
    let mut plain = all_sorts();
    for material in &mut plain.materials {
        (material.mirror, material.roughness) = ([0.0; 3], 0.0);
    }
    let mut with = plain.clone();
    with.materials[0].roughness = 0.5;
    with.materials
        .extend([mirror(1.0, 0.0, 0.0), mirror(0.5, 0.5, 0.5)]);
    with.materials.push(Material {
        ior: Some(1.5),
        absorption: [1.0; 3],
        ..Material::default()
    });
    let gpu = Backend::Gpu(Box::new(gpu()));
    for bounces in [0, 3] {
        let [plain, with] = [&plain, &with].map(|scene| {
            let mut scene = scene.clone();
            scene.integrator.samples = 4;
            scene.integrator.bounces = bounces;
            let made = rayproof::render(&scene, &gpu, BRUTE_FORCE, &Unwatched).unwrap();
            (made.frame, made.stats.effects.len())
        });
        assert_same_bits(&with.0, &plain.0);
        assert_eq!(with.1, plain.1 + 3);
    }
}

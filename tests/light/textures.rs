//! Textures: where on them a place lies, and which colour is there.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::hit::no_hit;
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::textures::{texture_color, texture_coordinates};
use rayproof::kernel::trace::{find_hit, surface_of};
use rayproof::kernel::vector::vec3;
use rayproof::layout::{NO_HIT, NONE};
use rayproof::random::Numbers;
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{
    Falloff, Geometry, Light, Material, Mesh, Pattern, Shape, Texels, Texture, Transform,
};
use rayproof::{Scene, Tolerance};

use crate::common::{assert_same_bits, compare, on_cpu, on_gpu};

fn textured(pattern: Pattern, repeat: [f64; 2], size: f64) -> Material {
    Material {
        albedo: [0.8, 0.6, 0.9],
        texture: Some(Texture {
            pattern,
            repeat,
            size,
        }),
        ..Material::default()
    }
}

fn checker() -> Pattern {
    Pattern::Checker([0.25, 0.5, 0.0])
}

/// An image of texels without any order.
fn image(width: u32, height: u32) -> Arc<Texels> {
    let mut random = Numbers(5);
    let mut channel = || random.between(0.0, 1.0) as f32;
    let count = width * height;
    let texels = (0..count).map(|_| std::array::from_fn(|_| channel()));
    Arc::new(Texels {
        name: "noise".into(),
        width,
        height,
        texels: texels.collect(),
    })
}

fn shape(geometry: Geometry, material: usize) -> Shape {
    Shape {
        geometry,
        transform: Transform::default(),
        material,
        velocity: DVec3::ZERO,
    }
}

fn scene(materials: Vec<Material>, shapes: Vec<Shape>) -> Scene {
    Scene {
        ambient: [1.0; 3],
        materials,
        shapes,
        ..Scene::default()
    }
}

#[test]
fn squares_of_a_checker_take_turns() {
    let flat: Flat<f32> = flatten(&scene(vec![textured(checker(), [1.0; 2], 1.0)], vec![]));
    let color = |u, v| texture_color(&flat, &flat.textures[0], [u, v]);
    let (mut white, mut other) = (0, 0);
    for i in -40..40 {
        for j in -40..40 {
            let (u, v) = (i as f32 / 8.0, j as f32 / 8.0);
            let parity = (2.0 * u).floor() + (2.0 * v).floor();
            if parity.rem_euclid(2.0) == 0.0 {
                assert_eq!(color(u, v), [1.0; 4], "{u}, {v}");
                white += 1;
            } else {
                assert_eq!(color(u, v), [0.25, 0.5, 0.0, 1.0], "{u}, {v}");
                other += 1;
            }
        }
    }
    assert_eq!(white, other);
    // Just below a seam, where the rest is rounded to 1; and far away, where there is none.
    assert_eq!(color(-1e-10, 0.1), color(0.9, 0.1));
    assert_ne!(color(-1e-10, 0.1), color(1e-10, 0.1));
    for far in [1e7, -1e8, 3e38, f32::INFINITY] {
        assert_eq!(color(far, 0.1), [1.0; 4]);
    }
}

/// What a texture of an image has at (u, v), in f64.
fn blended(image: &Texels, u: f64, v: f64) -> [f64; 4] {
    let (width, height) = (f64::from(image.width), f64::from(image.height));
    let (x, y) = (u * width - 0.5, (1.0 - v) * height - 0.5);
    let texel = |column: f64, row: f64| {
        let column = column.rem_euclid(width) as usize;
        let row = row.rem_euclid(height) as usize;
        image.texels[row * image.width as usize + column].map(f64::from)
    };
    let (column, row) = (x.floor(), y.floor());
    let (right, down) = (x - column, y - row);
    std::array::from_fn(|channel| {
        let across = |row| {
            let [a, b] = [column, column + 1.0].map(|column| texel(column, row)[channel]);
            a * (1.0 - right) + b * right
        };
        across(row) * (1.0 - down) + across(row + 1.0) * down
    })
}

#[test]
fn images_are_blended_between_the_middles_of_texels() {
    let noise = image(7, 5);
    let material = textured(Pattern::Image(noise.clone()), [1.0; 2], 1.0);
    let flat: Flat<f32> = flatten(&scene(vec![material], vec![]));
    let color = |u: f64, v: f64| texture_color(&flat, &flat.textures[0], [u as f32, v as f32]);
    // The place among the texels is off by three roundings of a number up to 8, each by 2^-22 at
    // most, in both directions; and a blend by eight of numbers up to 1.
    let most = (2.0 * 3.0 * 4.0 + 8.0) / f64::from(1 << 24);
    let off = |u: f64, v: f64, expected: [f64; 4]| {
        let found = color(u, v).map(f64::from);
        (0..4).fold(0.0, |worst: f64, i| {
            worst.max((found[i] - expected[i]).abs())
        })
    };
    for row in 0..5 {
        for column in 0..7 {
            let (u, v) = (
                (f64::from(column) + 0.5) / 7.0,
                1.0 - (f64::from(row) + 0.5) / 5.0,
            );
            let texel = noise.texels[row as usize * 7 + column as usize].map(f64::from);
            assert!(off(u, v, texel) <= most, "{column}, {row}");
            // The control: a texel further.
            assert!(off(u + 1.0 / 7.0, v, texel) > most);
        }
    }
    let mut random = Numbers(9);
    for _ in 0..20_000 {
        let [u, v] = [0, 1].map(|_| f64::from(random.between(0.0, 1.0) as f32));
        assert!(off(u, v, blended(&noise, u, v)) <= most, "{u}, {v}");
    }
}

/// The coordinates of what a ray meets.
fn coordinates_at(scene: &Scene, origin: DVec3, direction: DVec3) -> [f32; 2] {
    let flat: Flat<f32> = flatten(scene);
    let vector = |v: DVec3| vec3(v.x as f32, v.y as f32, v.z as f32);
    let ray = Ray {
        origin: vector(origin - scene.camera.eye),
        direction: vector(direction),
    };
    let mut hit = no_hit();
    find_hit(&flat, probe_of(ray), &mut hit);
    assert_ne!(hit.id, NO_HIT);
    let surface = surface_of(&flat, ray, hit);
    texture_coordinates(&flat, ray, hit, &surface, &flat.textures[0])
}

fn assert_near(found: [f32; 2], expected: [f64; 2]) {
    // Some ten roundings of numbers up to 8.
    let most = 10.0 * 4.0 / f64::from(1 << 23);
    for (found, expected) in found.into_iter().zip(expected) {
        let off = (f64::from(found) - expected).abs();
        assert!(off <= most, "{found} in place of {expected}");
        assert!(
            (f64::from(found) - expected - 1e-3).abs() > most,
            "the control"
        );
    }
}

#[test]
fn spheres_are_globes() {
    let center = DVec3::new(0.5, -1.0, -7.0);
    let ball = shape(
        Geometry::Sphere {
            center,
            radius: 2.0,
        },
        0,
    );
    let scene = scene(vec![textured(checker(), [4.0, 2.0], 1.0)], vec![ball]);
    let slant = DVec3::new(0.0, 1.0, 1.0).normalize();
    for (outward, [turn, height]) in [
        (DVec3::X, [0.5, 0.5]),
        (DVec3::Z, [0.25, 0.5]),
        (DVec3::NEG_Z, [0.75, 0.5]),
        (slant, [0.25, 0.75]),
        (DVec3::new(1.0, 0.0, 1.0).normalize(), [0.375, 0.5]),
    ] {
        let expected = [4.0 * turn, 2.0 * height];
        let from_outside = coordinates_at(&scene, center + 3.0 * outward, -outward);
        assert_near(from_outside, expected);
        assert_near(coordinates_at(&scene, center, outward), expected);
    }
    assert_eq!(
        coordinates_at(&scene, center + 3.0 * DVec3::Y, DVec3::NEG_Y)[1],
        2.0
    );
}

#[test]
fn triangles_take_the_coordinates_of_their_corners() {
    let corners = [DVec3::ZERO, 4.0 * DVec3::X, 4.0 * DVec3::Y];
    let mesh = |uvs: Vec<[f64; 2]>| {
        let mesh = Mesh {
            positions: corners.to_vec(),
            triangles: vec![[0, 1, 2]],
            uvs,
            triangle_uvs: vec![[0, 1, 2]],
            ..Mesh::default()
        };
        let mut scene = scene(
            vec![textured(checker(), [2.0, 3.0], 0.5)],
            vec![shape(Geometry::Mesh(Arc::new(mesh)), 0)],
        );
        scene.camera.eye = DVec3::new(1.0, 1.0, 5.0);
        scene
    };
    let with = mesh(vec![[0.0, 0.0], [1.0, 0.25], [0.5, 1.0]]);
    // A quarter of the second corner, a half of the third.
    let from = DVec3::new(1.0, 2.0, 3.0);
    let [u, v] = [0.25 + 0.25, 0.0625 + 0.5];
    assert_near(
        coordinates_at(&with, from, DVec3::NEG_Z),
        [2.0 * u, 3.0 * v],
    );
    // Without, by the place in the world.
    let without = mesh(vec![[0.0; 2]; 3]);
    let camera = without.camera.eye;
    let in_world = coordinates_at(&without, from, DVec3::NEG_Z);
    assert_near(in_world, places(from, camera, 0.5, [0, 1]));
    // One that is not 0, 0 is enough.
    let some = mesh(vec![[0.0; 2], [0.0; 2], [0.0, 1.0]]);
    assert_near(coordinates_at(&some, from, DVec3::NEG_Z), [0.0, 1.5]);
}

/// A place's coordinates along two axes in repeats of the world; those of the camera less whole
/// ones.
fn places(place: DVec3, eye: DVec3, size: f64, axes: [usize; 2]) -> [f64; 2] {
    axes.map(|axis| (place[axis] - eye[axis] + eye[axis].rem_euclid(size)) / size)
}

#[test]
fn other_shapes_take_the_axes_that_they_lie_along() {
    let eye = DVec3::new(10.3, -20.7, 30.1);
    let place = DVec3::new(9.0, -22.0, 28.5);
    let size = 0.8;
    for (normal, axes) in [
        (DVec3::X, [2, 1]),
        (DVec3::Y, [0, 2]),
        (DVec3::Z, [0, 1]),
        (DVec3::new(0.2, -0.9, 0.3), [0, 2]),
        (DVec3::new(-0.8, 0.5, 0.3), [2, 1]),
    ] {
        let plane = Geometry::Plane {
            point: place,
            normal,
        };
        let disk = Geometry::Disk {
            center: place + DVec3::splat(0.01),
            normal,
            radius: 3.0,
        };
        let across = normal.any_orthonormal_vector();
        let other = normal.cross(across).normalize();
        let triangle = Geometry::Triangle {
            vertices: [
                place + across + other,
                place - 2.0 * across,
                place - 2.0 * other,
            ],
        };
        for geometry in [plane, disk, triangle] {
            let is_disk = matches!(geometry, Geometry::Disk { .. });
            let mut scene = scene(
                vec![textured(checker(), [5.0, 7.0], size)],
                vec![shape(geometry, 0)],
            );
            scene.camera.eye = eye;
            let found = coordinates_at(&scene, place + normal, -normal);
            let expected = if is_disk {
                let along = normal.normalize();
                place + along * DVec3::splat(0.01).dot(along)
            } else {
                place
            };
            assert_near(found, places(expected, eye, size, axes));
        }
    }
}

/// A checkered floor, and a box, seen from a place; the world is moved as well.
fn moved(by: DVec3, size: f64) -> Scene {
    let mesh = Shape {
        transform: Transform {
            linear: DMat3::from_diagonal(DVec3::splat(1.5)),
            translate: by + DVec3::new(0.5, -0.5, -4.0),
        },
        ..shape(Geometry::Mesh(Arc::new(build(Builtin::Knot, 500))), 0)
    };
    let floor = Geometry::Plane {
        point: by - DVec3::Y,
        normal: DVec3::Y,
    };
    let mut scene = scene(
        vec![textured(checker(), [8.0, 2.0], size)],
        vec![shape(floor, 0), mesh],
    )
    .with_size(64, 48);
    scene.camera.eye = by + DVec3::new(0.25, 0.5, 0.0);
    scene.camera.target = by + DVec3::new(0.25, 0.0, -3.0);
    scene
}

/// All numbers are multiples of powers of 2 that f64 holds in either place.
#[test]
fn a_checker_far_away_is_as_near() {
    let near = on_cpu(&moved(DVec3::ZERO, 0.5));
    let far = on_cpu(&moved(DVec3::new(1e6, 0.0, -3e6), 0.5));
    assert_same_bits(&near, &far);
    // The control: by half a repeat, which exchanges the squares.
    let other = on_cpu(&moved(DVec3::new(1e6 + 0.25, 0.0, -3e6), 0.5));
    let change = rayproof::compare_frames(&near, &other, &Tolerance::default()).unwrap();
    assert!(change.different_pixels > 0);
}

/// Every kind of shape with a checker and an image.
pub fn all_kinds(samples: u32) -> Scene {
    let noise = image(16, 9);
    let mesh = |kind, x: f64| Shape {
        transform: Transform {
            linear: DMat3::from_diagonal(DVec3::splat(0.7)),
            translate: DVec3::new(x, -0.2, -4.0),
        },
        ..shape(Geometry::Mesh(Arc::new(build(kind, 300))), 1)
    };
    let vertices = [
        DVec3::new(-3.0, 0.5, -6.0),
        DVec3::new(3.0, 0.2, -6.5),
        DVec3::new(0.3, 3.0, -5.0),
    ];
    let mut scene = scene(
        vec![
            textured(checker(), [8.0, 4.0], 0.7),
            textured(Pattern::Image(noise.clone()), [3.0, 2.0], 1.1),
            textured(Pattern::Image(noise), [1.0, 1.0], 0.3),
            Material::default(),
        ],
        vec![
            shape(
                Geometry::Sphere {
                    center: DVec3::new(-1.2, 0.0, -4.0),
                    radius: 0.8,
                },
                0,
            ),
            shape(
                Geometry::Sphere {
                    center: DVec3::new(1.8, 0.9, -4.0),
                    radius: 0.5,
                },
                1,
            ),
            shape(
                Geometry::Plane {
                    point: DVec3::NEG_Y,
                    normal: DVec3::new(0.1, 1.0, 0.05),
                },
                0,
            ),
            shape(
                Geometry::Disk {
                    center: DVec3::new(0.0, 1.0, -4.0),
                    normal: DVec3::new(0.3, 0.2, 1.0),
                    radius: 0.5,
                },
                2,
            ),
            shape(Geometry::Triangle { vertices }, 2),
            mesh(Builtin::Teapot, 0.4),
            mesh(Builtin::Box, 1.7),
            shape(
                Geometry::Sphere {
                    center: DVec3::new(-2.0, 1.3, -4.5),
                    radius: 0.4,
                },
                3,
            ),
        ],
    )
    .with_size(80, 60);
    scene.ambient = [0.1; 3];
    scene.lights = vec![Light::Point {
        position: DVec3::new(2.0, 4.0, 1.0),
        color: [20.0; 3],
        falloff: Falloff::InverseSquare,
        shadow: true,
    }];
    scene.integrator.samples = samples;
    scene.integrator.bounces = 2;
    scene
}

#[test]
fn textures_have_the_same_bits_on_both_sides() {
    let scene = all_kinds(4);
    let cpu = on_cpu(&scene);
    assert_same_bits(&cpu, &on_gpu(&scene));
    let mut plain = scene;
    for material in &mut plain.materials {
        material.texture = None;
    }
    let change = compare(&cpu, &on_cpu(&plain));
    assert!(change.different_pixels > 1000, "the control");
}

#[test]
fn an_image_that_is_shared_is_kept_once() {
    let scene = all_kinds(1);
    let flat: Flat<f32> = flatten(&scene);
    assert_eq!(flat.texels.len(), 16 * 9);
    assert_eq!(flat.textures.len(), 3);
    let indices: Vec<u32> = flat.finishes.iter().map(|finish| finish.texture).collect();
    assert_eq!(indices, [0, 1, 2, NONE]);
    assert_eq!((flat.textures[0].width, flat.textures[2].width), (0, 16));
    let mut without = flat.clone();
    without.texels = Arc::default();
    assert_eq!(flat.bytes() - without.bytes(), 16 * 16 * 9);
}

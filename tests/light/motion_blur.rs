//! Shapes and a camera that move while the shutter is open.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use rayproof::bounds::Bounds;
use rayproof::render::Settings;
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{Geometry, Light, Material, Shape, Transform};
use rayproof::{Accuracy, Backend, Frame, Scene, Unwatched};

use crate::common::{assert_same_bits, gpu, white_scene};

const SAMPLES: u32 = 256;

fn shape(geometry: Geometry, velocity: DVec3) -> Shape {
    Shape {
        geometry,
        transform: Transform::default(),
        material: 0,
        velocity,
    }
}

fn on(backend: &Backend, scene: &Scene, settings: impl Into<Settings>) -> Frame {
    rayproof::render(scene, backend, settings, &Unwatched)
        .unwrap()
        .frame
}

/// Every kind of shape on its way, and the camera, in light that throws shadows.
fn all_that_moves() -> Scene {
    let mesh = |kind, velocity| Shape {
        transform: Transform {
            linear: DMat3::from_diagonal(DVec3::splat(0.8)),
            translate: DVec3::new(1.4, 0.2, -4.0),
        },
        ..shape(Geometry::Mesh(Arc::new(build(kind, 300))), velocity)
    };
    let sphere = |x: f64, y: f64, radius| Geometry::Sphere {
        center: DVec3::new(x, y, -4.0),
        radius,
    };
    let mut scene = white_scene(vec![
        shape(sphere(-1.5, 0.3, 0.6), DVec3::new(0.7, -0.2, 0.4)),
        shape(sphere(-0.2, -0.5, 0.3), DVec3::ZERO),
        // A planet: the camera is near its surface, and its power is another at each time.
        shape(
            Geometry::Sphere {
                center: DVec3::new(0.0, -5001.0, 0.0),
                radius: 5000.0,
            },
            DVec3::new(0.0, 0.3, 0.0),
        ),
        shape(
            Geometry::Plane {
                point: DVec3::new(0.0, 0.0, -9.0),
                normal: DVec3::new(0.1, 0.2, 1.0).normalize(),
            },
            DVec3::new(3.0, 0.0, 1.0),
        ),
        shape(
            Geometry::Disk {
                center: DVec3::new(0.0, 1.1, -4.0),
                normal: DVec3::new(0.3, 0.2, 1.0).normalize(),
                radius: 0.5,
            },
            DVec3::new(-0.5, 0.5, 0.0),
        ),
        mesh(Builtin::Knot, DVec3::new(0.1, 0.6, -0.3)),
        shape(
            Geometry::Triangle {
                vertices: [
                    DVec3::new(-2.0, 1.0, -5.0),
                    DVec3::new(-1.0, 1.2, -4.0),
                    DVec3::new(-1.6, 2.0, -4.5),
                ],
            },
            DVec3::new(0.0, -0.4, 0.0),
        ),
    ])
    .with_size(61, 43);
    scene.ambient = [0.1; 3];
    scene.lights = vec![Light::Directional {
        direction: DVec3::new(0.5, 1.0, 0.4),
        color: [1.0; 3],
        shadow: true,
    }];
    scene.camera.velocity = DVec3::new(0.2, 0.1, -0.1);
    scene.camera.aperture = 0.1;
    scene.integrator.samples = 3;
    scene.integrator.bounces = 1;
    scene
}

const CHOICES: [Bounds; 7] = [
    Bounds::Scene,
    Bounds::Spheres { levels: 1 },
    Bounds::Spheres { levels: 3 },
    Bounds::Boxes { levels: 1 },
    Bounds::Boxes { levels: 3 },
    Bounds::Screen { levels: 2 },
    Bounds::Tree,
];

/// Both sides show the same, and volumes hold what moves on all its way.
#[test]
fn bits_are_the_same_everywhere() {
    let scene = all_that_moves();
    let gpu = Backend::Gpu(Box::new(gpu()));
    let with = |bounds| Settings {
        accuracy: Accuracy::Robust,
        bounds,
        forced: rayproof::effects::EffectSet::NONE,
    };
    let reference = on(&Backend::Cpu(None), &scene, with(Bounds::None));
    assert_same_bits(&reference, &on(&gpu, &scene, with(Bounds::None)));
    for bounds in CHOICES {
        assert_same_bits(&reference, &on(&Backend::Cpu(None), &scene, with(bounds)));
    }
    for bounds in [
        Bounds::Spheres { levels: 2 },
        Bounds::Boxes { levels: 2 },
        Bounds::Tree,
    ] {
        assert_same_bits(&reference, &on(&gpu, &scene, with(bounds)));
    }
    // The control: other pictures, where nothing moves, or one shape less.
    for index in [None, Some(0), Some(2), Some(3), Some(4), Some(5), Some(6)] {
        let mut other = scene.clone();
        match index {
            None => other.camera.velocity = DVec3::ZERO,
            Some(index) => other.shapes[index].velocity = DVec3::ZERO,
        }
        let other = on(&Backend::Cpu(None), &other, with(Bounds::Tree));
        assert!(!other.has_bits_of(&reference), "{index:?}");
    }
}

/// In the other tiers shapes go the same ways.
#[test]
fn bits_are_the_same_in_every_tier() {
    let scene = all_that_moves().with_size(23, 17);
    let gpu = Backend::Gpu(Box::new(gpu()));
    for accuracy in [Accuracy::Textbook, Accuracy::Extended, Accuracy::Double] {
        if gpu.lacks(accuracy).is_some() {
            continue;
        }
        let settings = Settings {
            accuracy,
            bounds: Bounds::None,
            forced: rayproof::effects::EffectSet::NONE,
        };
        let reference = on(&Backend::Cpu(None), &scene, settings);
        assert_same_bits(&reference, &on(&gpu, &scene, settings));
        if accuracy != Accuracy::Textbook {
            assert_same_bits(&reference, &on(&Backend::Cpu(None), &scene, accuracy));
        }
    }
}

/// A shape that no ray meets brings the readers of what moves along: what stands still is
/// still the same.
#[test]
fn what_stands_still_is_the_same_beside_what_moves() {
    let mut scene = all_that_moves();
    scene.camera.velocity = DVec3::ZERO;
    for shape in &mut scene.shapes {
        shape.velocity = DVec3::ZERO;
    }
    scene.integrator.bounces = 0;
    scene.lights.clear();
    let behind = Geometry::Triangle {
        vertices: [DVec3::X, DVec3::Y, DVec3::ONE].map(|v| v * 0.1 + DVec3::Z * 50.0),
    };
    // The planet is near, and its power is known, in both.
    scene.shapes.push(shape(behind, DVec3::ZERO));
    let gpu = Backend::Gpu(Box::new(gpu()));
    for bounds in [Bounds::None, Bounds::Tree] {
        let settings = Settings {
            accuracy: Accuracy::Robust,
            bounds,
            forced: rayproof::effects::EffectSet::NONE,
        };
        let mut moving = scene.clone();
        moving.shapes.last_mut().unwrap().velocity = DVec3::X;
        for backend in [&gpu, &Backend::Cpu(None)] {
            assert_same_bits(
                &on(backend, &scene, settings),
                &on(backend, &moving, settings),
            );
        }
    }
}

/// A disk that shines, seen straight on from a distance of 1: `unit` pixels are as long as 1.
fn bright_disk(radius: f64, velocity: DVec3) -> Scene {
    let disk = Geometry::Disk {
        center: DVec3::new(0.0, 0.0, -1.0),
        normal: DVec3::Z,
        radius,
    };
    let mut scene = white_scene(vec![shape(disk, velocity)]).with_size(96, 48);
    scene.ambient = [0.0; 3];
    scene.materials = vec![Material {
        albedo: [0.0; 3],
        emission: [1.0; 3],
        ..Material::default()
    }];
    scene.camera.fov_degrees = 90.0;
    scene.integrator.samples = SAMPLES;
    scene
}

/// Pixels in a length of 1 there.
const UNIT: f64 = 24.0;

/// The light of each column of pixels, in pixels that are covered.
fn columns(frame: &Frame) -> Vec<f64> {
    let width = frame.width as usize;
    let rows = frame.color.chunks(width);
    rows.fold(vec![0.0; width], |mut sums, row| {
        for (sum, color) in sums.iter_mut().zip(row) {
            *sum += f64::from(color[0]);
        }
        sums
    })
}

/// The second integral of a circle's chords, from its left edge to x.
fn twice_integrated(x: f64, radius: f64) -> f64 {
    let inside = x.clamp(-radius, radius);
    let height = (radius * radius - inside * inside).sqrt();
    let square = radius * radius;
    let sectors = square * (inside * (inside / radius).asin() + height) - height.powi(3) / 3.0;
    let half = std::f64::consts::FRAC_PI_2 * square;
    // From its left edge on, and beyond the right one, where all of the circle is to the left.
    sectors + half * inside + 2.0 * half * (x - radius).max(0.0)
}

/// What of a disk, smeared over a length, lies between two verticals.
fn smeared(from: f64, to: f64, radius: f64, length: f64) -> f64 {
    let ends = |x: f64| {
        let (right, left) = (x + length / 2.0, x - length / 2.0);
        twice_integrated(right, radius) - twice_integrated(left, radius)
    };
    (ends(to) - ends(from)) / length
}

/// Columns of the picture whose light is not that of a disk smeared so far.
///
/// A sample finds the disk or not, so the variance of a pixel's mean is at most the mean over
/// the number of samples, and that of a column is the sum; five standard errors are left.
fn wrong_columns(frame: &Frame, radius: f64, length: f64) -> usize {
    let middle = f64::from(frame.width) / 2.0;
    let columns = columns(frame);
    let is_wrong = |(x, light): (usize, &f64)| {
        let from = x as f64 - middle;
        let expected = smeared(from, from + 1.0, radius * UNIT, length * UNIT);
        (light - expected).abs() > 5.0 * (expected / f64::from(SAMPLES)).sqrt() + 1e-6
    };
    let all = columns.iter().enumerate();
    all.filter(|&column| is_wrong(column)).count()
}

/// The light of a disk that moves is smeared evenly along its way.
#[test]
fn a_moving_disk_is_smeared_along_its_way() {
    let radius = 0.3;
    for length in [0.25, 1.0, 2.5] {
        let scene = bright_disk(radius, DVec3::X * length);
        let frame = on(&Backend::Cpu(None), &scene, Accuracy::Robust);
        assert_eq!(wrong_columns(&frame, radius, length), 0, "{length}");
        // The controls: another length, another radius.
        assert!(wrong_columns(&frame, radius, length * 1.3) > 0, "{length}");
        assert!(wrong_columns(&frame, radius * 1.1, length) > 0, "{length}");
    }
}

/// To move the camera is to move all else the other way.
#[test]
fn a_moving_camera_sees_all_else_move_the_other_way() {
    let velocity = DVec3::new(0.5, 0.25, 0.0);
    let still = bright_disk(0.3, DVec3::ZERO);
    let mut with_camera = still.clone();
    with_camera.camera.velocity = velocity;
    let camera = on(&Backend::Cpu(None), &with_camera, Accuracy::Robust);
    let shapes = bright_disk(0.3, -velocity);
    let shapes = on(&Backend::Cpu(None), &shapes, Accuracy::Robust);
    // Difference of the places: the disk's test takes its own from the origin's, and rounding
    // does not know left from right.
    assert_eq!(camera.color, shapes.color);
    let same_way = bright_disk(0.3, velocity);
    let same_way = on(&Backend::Cpu(None), &same_way, Accuracy::Robust);
    assert_ne!(camera.color, same_way.color, "the control");
}

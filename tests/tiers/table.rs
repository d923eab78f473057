//! The spheres far away and large of which `docs/numerics.md` has a table.

use glam::DVec3;
use rayproof::accuracy::{Errors, Truths, Widths};
use rayproof::bounds::Bounds;
use rayproof::flatten::flatten;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::vector::vec3;
use rayproof::scene::{Geometry, Shape, Transform};
use rayproof::{Accuracy, Backend, Unwatched};

use super::common::random::Numbers;
use super::common::white_scene;

const RAYS: usize = 32_768;

/// The errors of each tier on rays at a sphere, whose distances from its centre are up to
/// 1.05 of its radius.
fn errors(radius: f64, distance: f64, accuracy: Accuracy) -> Errors {
    // Along no axis, and the same in f32.
    let center = (DVec3::new(0.36, 0.48, -0.8) * distance)
        .as_vec3()
        .as_dvec3();
    let sphere = Shape {
        geometry: Geometry::Sphere { center, radius },
        transform: Transform::default(),
        material: 0,
        velocity: DVec3::ZERO,
    };
    let mut scene = white_scene(vec![sphere]);
    scene.camera.eye = DVec3::ZERO;
    scene.camera.target = -DVec3::Z;
    let widths = Widths::of(flatten::<f64>(&scene), Bounds::None);
    let mut n = Numbers(1);
    let rays: Vec<Ray<f32>> = (0..RAYS)
        .map(|index| {
            let impact = 1.05 * radius * index as f64 / RAYS as f64;
            // The sine and the cosine of the angle at which a ray passes so near.
            let across = (impact / distance).min(1.0);
            let along = (1.0 - across * across).sqrt();
            let axis = center.normalize();
            let side = axis.cross(n.vector(1.0)).normalize();
            let length = n.between(0.5, 2.0);
            let direction = ((axis * along + side * across) * length).as_vec3();
            Ray {
                origin: vec3(0.0, 0.0, 0.0),
                direction: direction.to_array().into(),
            }
        })
        .collect();
    let exact: Vec<Ray<f64>> = rays.iter().map(|ray| ray.converted()).collect();
    let truths = Truths::of(&widths.double, &exact, &Unwatched).unwrap();
    let found = widths.trace_rays(&Backend::Cpu(None), accuracy, &rays);
    Errors::of(&found.unwrap().0, &truths.0)
}

/// Rays that hit where they should not, or the other way.
fn wrong(distance: f64) -> [u64; 5] {
    Accuracy::ALL.map(|accuracy| errors(1.0, distance, accuracy).misclassified)
}

#[test]
fn a_sphere_far_away() {
    let [textbook, others @ ..] = wrong(1e3);
    assert!((100..2000).contains(&textbook), "{textbook}");
    assert_eq!(others, [0; 4]);
    let [textbook, robust, others @ ..] = wrong(1e4);
    assert!((3000..20_000).contains(&textbook), "{textbook}");
    assert!(robust <= 5, "{robust}");
    assert_eq!(others, [0; 3]);
    let [_, robust, others @ ..] = wrong(1e6);
    assert!((100..1000).contains(&robust), "{robust}");
    assert_eq!(others, [0; 3]);
}

#[test]
fn a_large_sphere_seen_from_near() {
    let medians = Accuracy::ALL.map(|accuracy| errors(1e6, 1e6 + 1.0, accuracy).ulp_p50);
    let [textbook, robust, extended, double, adaptive] = medians;
    assert!(textbook > 1e4, "{medians:?}");
    // The host computes how high the camera is.
    assert!(robust < 1.0 && adaptive < 1.0, "{medians:?}");
    assert!(extended < 1e-2 && double < 1e-2, "{medians:?}");
}

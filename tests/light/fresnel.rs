//! What the surface of a clear body throws back, from square to grazing, from both sides.

use glam::DVec3;
use rayproof::Scene;
use rayproof::scene::{Geometry, Material};

use crate::seen::{FAR, ROUNDING, by_height, looking_at, mean_of};

/// The surface's normal on the camera's side.
const TO_CAMERA: DVec3 = DVec3::new(0.6, 0.8, 0.0);

/// A clear body without end, its surface seen at a cosine: from without, or from within.
fn half_space(ior: f64, cosine: f64, is_within: bool) -> Scene {
    let sine = (1.0 - cosine * cosine).sqrt();
    let towards = -(TO_CAMERA * cosine) - DVec3::Z * sine;
    let glass = Material {
        ior: Some(ior),
        ..Material::default()
    };
    let plane = Geometry::Plane {
        point: towards * 3.0,
        normal: if is_within { -TO_CAMERA } else { TO_CAMERA },
    };
    let mut scene = looking_at(vec![plane], glass).with_size(16, 16);
    scene.background = by_height();
    scene.camera.target = towards;
    scene.camera.up = DVec3::X;
    scene.integrator.samples = 64;
    scene
}

/// By the angles on both sides: Born, Wolf, 1.5.2, (20) and (21), as sines and tangents.
fn fresnel(here: f64, beyond: f64) -> f64 {
    let across = (here - beyond).sin() / (here + beyond).sin();
    let along = (here - beyond).tan() / (here + beyond).tan();
    0.5 * (across * across + along * along)
}

/// What is seen: thrown back the sky by one height, through the surface by another.
fn expected(scene: &Scene, cosine: f64, ratio: f64, part: f64) -> f64 {
    let ray = scene.camera.target;
    let height = |direction: DVec3| (1.0 + direction.y) / 2.0;
    let back = height(ray + TO_CAMERA * (2.0 * cosine));
    let square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    if square <= 0.0 {
        return back;
    }
    let through = ray * ratio + TO_CAMERA * (ratio * cosine - square.sqrt());
    part * back + (1.0 - part) * height(through)
}

#[test]
fn surfaces_throw_back_as_fresnel_says() {
    let mut schlick_differs = 0;
    for ior in [1.33, 1.5, 2.4] {
        for is_within in [false, true] {
            for cosine in [1.0, 0.9, 0.7, 0.4, 0.1, 0.02] {
                let scene = half_space(ior, cosine, is_within);
                let ratio: f64 = if is_within { ior } else { 1.0 / ior };
                let sine = (1.0f64 - cosine * cosine).sqrt();
                let straight = ((ior - 1.0) / (ior + 1.0)).powi(2);
                let part = if cosine == 1.0 {
                    straight
                } else if sine * ratio >= 1.0 {
                    1.0
                } else {
                    fresnel(sine.asin(), (sine * ratio).asin())
                };
                let mean = mean_of(&scene);
                // The picture is 0.001 degrees wide: directions, and heights, are as much off.
                let most = FAR * mean.error + 64.0 * ROUNDING + 2e-5;
                let off = |part| {
                    let exact = expected(&scene, cosine, ratio, part);
                    (mean.color[0] - exact).abs()
                };
                assert!(
                    off(part) <= most,
                    "{ior} {cosine} {is_within}: {:?}",
                    mean.color
                );
                let schlick = straight + (1.0 - straight) * (1.0 - cosine).powi(5);
                schlick_differs += usize::from(off(schlick) > most);
            }
        }
    }
    // The control: what mirrors are told by is something else.
    assert!(schlick_differs >= 6, "{schlick_differs}");
}

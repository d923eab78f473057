//! An offset that does not round changes no bit.

use glam::DVec3;
use rayproof::bounds::Bounds;
use rayproof::scene::{GroupBound, Light};
use rayproof::{Accuracy, Backend, Scene};

use super::{TIERS, assert_holds, different, generated, mapped, picture};

/// Places as multiples of 2^-10, so that whole numbers can be added to them.
fn dyadic(mut scene: Scene) -> Scene {
    let round = |v: &mut DVec3| *v = (*v * 1024.0).round() / 1024.0;
    round(&mut scene.camera.eye);
    round(&mut scene.camera.target);
    for light in &mut scene.lights {
        if let Light::Point { position, .. } = light {
            round(position);
        }
    }
    for shape in &mut scene.shapes {
        round(&mut shape.transform.translate);
    }
    for group in &mut scene.groups {
        match &mut group.bound {
            GroupBound::Auto => {}
            GroupBound::Ball { center, .. } => round(center),
            GroupBound::Box { low, high } => [low, high].into_iter().for_each(round),
        }
    }
    scene
}

fn moved(scene: &Scene, by: DVec3) -> Scene {
    mapped(scene, DVec3::ONE, by)
}

#[test]
fn an_exact_offset_changes_no_bit() {
    for by in [
        DVec3::new(1e6, -12_345.0, 0.5),
        DVec3::new(-3e12, 1e12, 7e11),
    ] {
        assert_holds(
            &by.to_string(),
            |scene| moved(scene, by),
            Clone::clone,
            &TIERS,
            |seed| dyadic(generated(seed)),
        );
    }
}

/// The controls: an offset that rounds, and a single shape that is moved.
#[test]
fn other_offsets_are_noticed() {
    let scene = dyadic(generated(0));
    let see = |scene: &Scene| picture(scene, &Backend::Cpu(None), Accuracy::Double, Bounds::Tree);
    let here = see(&scene);
    assert!(different(&here, &see(&moved(&scene, DVec3::splat(1e14 + 0.1)))) > 100);
    let mut other = scene.clone();
    for shape in &mut other.shapes {
        shape.transform.translate.x += 2f64.powi(-20);
    }
    assert!(different(&here, &see(&other)) > 100);
}

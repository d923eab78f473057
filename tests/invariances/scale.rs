//! A power of two as the scale changes no bit, and lengths by that factor.

use glam::DVec3;
use rayproof::bounds::Bounds;
use rayproof::scene::{Falloff, Light};
use rayproof::{Accuracy, Backend, Frame, Scene};

use super::{TIERS, assert_holds, different, generated, mapped, picture};

/// The scene with every length times `factor`, and equally bright.
fn scaled(scene: &Scene, factor: f64) -> Scene {
    let mut scene = mapped(scene, DVec3::splat(factor), DVec3::ZERO);
    for light in &mut scene.lights {
        if let Light::Point {
            color,
            falloff: Falloff::InverseSquare,
            ..
        } = light
        {
            *color = color.map(|channel| channel * factor * factor);
        }
    }
    scene
}

fn lengths_scaled(frame: &Frame, factor: f32) -> Frame {
    let mut frame = frame.clone();
    frame.depth.iter_mut().for_each(|depth| *depth *= factor);
    for position in &mut frame.position {
        *position = position.map(|number| number * factor);
    }
    frame
}

fn holds(exponents: &[i32], tiers: &[Accuracy], first: u64) {
    for &exponent in exponents {
        let factor = 2f64.powi(exponent);
        assert_holds(
            &format!("2^{exponent}"),
            |scene| scaled(scene, factor),
            |frame| lengths_scaled(frame, factor as f32),
            tiers,
            |seed| generated(2 * seed + first),
        );
    }
}

/// As small as the least shape lets it become, and as large as a scene may reach. In two f32,
/// whose rests lie 2^-24 below, squares of small lengths would vanish sooner.
#[test]
fn a_power_of_two_changes_no_bit() {
    holds(&[-40, 44], &[TIERS[0], TIERS[2], TIERS[3]], 0);
    holds(&[-12, 44], &[Accuracy::Extended], 0);
}

/// A lamp that weakens with the square of the distance is to be brighter by the square of the
/// scale, and no number may be past 1e15.
#[test]
fn inverse_squares_change_no_bit() {
    holds(&[-30, 24], &[Accuracy::Robust], 1);
}

/// The controls: a factor that rounds, and the textbook's fixed lengths.
#[test]
fn other_factors_and_fixed_lengths_are_noticed() {
    let scene = generated(0);
    let differing = |factor: f64, accuracy| {
        let [here, there] = [&scene, &scaled(&scene, factor)]
            .map(|scene| picture(scene, &Backend::Cpu(None), accuracy, Bounds::None));
        different(&lengths_scaled(&here, factor as f32), &there)
    };
    assert!(differing(3.0, Accuracy::Robust) > 100);
    assert!(differing(2f64.powi(-20), Accuracy::Textbook) > 100);
    assert_eq!(differing(2f64.powi(-20), Accuracy::Robust), 0);
}

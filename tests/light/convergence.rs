//! How fast the noise of a picture falls.

use std::sync::OnceLock;

use rayproof::render::{Accuracy, Backend};
use rayproof::{Frame, Scene, Unwatched};

use crate::sampled::{ERRORS, Mean};
use crate::scenes::{picture, room};

/// Samples of the picture that stands for what all pictures come to.
const CONVERGED: u32 = 2048;

fn of(samples: u32, seed: u32) -> Scene {
    let mut scene = room(20, samples, 1);
    scene.integrator.seed = seed;
    scene
}

/// What all pictures come to.
fn converged() -> &'static Frame {
    static CONVERGED_FRAME: OnceLock<Frame> = OnceLock::new();
    CONVERGED_FRAME.get_or_init(|| picture(&of(CONVERGED, 1), &Backend::Cpu(None)))
}

/// The square of how far a picture is off, its mean and how sure that is.
fn error(frame: &Frame, converged: &Frame, brighter: f64) -> Mean {
    let pairs = frame.color.iter().zip(&converged.color);
    Mean::of(pairs.map(|(found, exact)| {
        let channels = found.iter().zip(exact);
        channels
            .map(|(found, exact)| f64::from(*found) - brighter * f64::from(*exact))
            .map(|off| off * off)
            .sum()
    }))
}

/// What is known of a picture's error: its root, and that as a part of it.
struct Off {
    root: f64,
    unsure: f64,
}

/// Of four times the samples the error is half at most: so it is where they are drawn by chance,
/// and these are spread more evenly. Errors of pixels know nothing of each other, so their mean
/// square is as sure as their number allows, and its root in parts half as unsure.
#[test]
fn four_times_the_samples_halve_the_error() {
    let cpu = Backend::Cpu(None);
    let converged = converged();
    let counts = [4, 16, 64, 256];
    let frames = counts.map(|samples| picture(&of(samples, 2), &cpu));
    let errors = |brighter| {
        [0, 1, 2, 3].map(|index| {
            let square = error(&frames[index], converged, brighter);
            Off {
                root: square.value.sqrt(),
                unsure: square.error / square.value / 2.0,
            }
        })
    };
    // What the converged picture itself is off by, a part of CONVERGED / 256, counts as well:
    // by a part in 16 of the root.
    let most = |one: &Off, two: &Off| 1.0 + ERRORS * one.unsure.hypot(two.unsure) + 1.0 / 16.0;
    let errors_now = errors(1.0);
    for (index, pair) in errors_now.windows(2).enumerate() {
        let [one, two] = pair else { unreachable!() };
        let fell = one.root / two.root;
        println!("{}: {:.2e}, {fell:.2}", counts[index], one.root);
        assert!(fell * most(one, two) > 2.0, "{}: {fell}", counts[index]);
    }
    // Over all of it, by the exponent.
    let [first, .., last] = &errors_now;
    let exponent = (first.root / last.root).ln() / 64f64.ln();
    let unsure = most(first, last).ln() / 64f64.ln();
    println!("exponent {exponent:.3} +- {unsure:.3}");
    assert!(exponent + unsure > 0.5, "{exponent} {unsure}");
    // The control: a picture that comes to something else, by a part in 4.
    let [first, .., last] = &errors(1.25);
    let exponent = (first.root / last.root).ln() / 64f64.ln();
    let unsure = most(first, last).ln() / 64f64.ln();
    assert!(exponent + unsure < 0.5, "the control: {exponent} {unsure}");
}

/// The noise that is told is the error that is made, or more: samples are spread more evenly
/// than by chance.
#[test]
fn the_noise_that_is_told_is_no_less_than_the_error() {
    let cpu = Backend::Cpu(None);
    let converged = converged();
    let bright = |[r, g, b]: [f32; 3]| f64::from(0.2126 * r + 0.7152 * g + 0.0722 * b);
    for samples in [16, 64] {
        let made = rayproof::render(&of(samples, 2), &cpu, Accuracy::Robust, &Unwatched).unwrap();
        let pixels = made.frame.color.len() as f64;
        let mean = made.frame.color.iter().map(|c| bright(*c)).sum::<f64>() / pixels;
        let pairs = made.frame.color.iter().zip(&converged.color);
        let square =
            Mean::of(pairs.map(|(found, exact)| (bright(*found) - bright(*exact)).powi(2)));
        let told = (made.stats.noise.unwrap() * mean).powi(2);
        println!("{samples}: told {told:.2e}, {square:?}");
        assert!(square.value - ERRORS * square.error < told);
        // The control: it is not told to be ten times as much.
        assert!(square.value + ERRORS * square.error > told / 100.0);
    }
}

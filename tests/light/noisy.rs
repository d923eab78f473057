//! Pictures that are noisy, and whether two of them may be of one scene.

use rayproof::render::{Accuracy, Backend, render};
use rayproof::{Scene, Unwatched};

use crate::sampled::ERRORS;

/// A picture's luminances, and its estimated error per pixel.
pub struct Noisy {
    pub pixels: Vec<f64>,
    /// Standard errors of the pixels, the root of their mean square.
    pub error: f64,
}

impl Noisy {
    /// Of a picture from the CPU.
    pub fn of(scene: &Scene) -> Self {
        let made = render(scene, &Backend::Cpu(None), Accuracy::Robust, &Unwatched).unwrap();
        assert_eq!(made.stats.faults, 0);
        let bright = |[r, g, b]: [f32; 3]| f64::from(0.2126 * r + 0.7152 * g + 0.0722 * b);
        let pixels: Vec<f64> = made
            .frame
            .color
            .iter()
            .map(|color| bright(*color))
            .collect();
        let mean = pixels.iter().sum::<f64>() / pixels.len() as f64;
        Self {
            error: made.stats.noise.unwrap() * mean,
            pixels,
        }
    }

    /// Whether both may be of one scene: by the mean, and pixel by pixel.
    ///
    /// Samples of a pixel are spread more evenly than by chance, so that its error is less
    /// than what is estimated by their variance.
    pub fn agrees(&self, other: &Self) -> bool {
        let count = self.pixels.len() as f64;
        let pairs = self.pixels.iter().zip(&other.pixels);
        let (mut sum, mut squares) = (0.0, 0.0);
        for (one, two) in pairs {
            sum += one - two;
            squares += (one - two) * (one - two);
        }
        let expected = self.error * self.error + other.error * other.error;
        let mean_fits = (sum / count).abs() <= ERRORS * (expected / count).sqrt();
        // The sum of so many squares is off by its own root of 2 / count, if they are normal;
        // of rare bright samples their fourth moment is some ten times as large.
        let slack = 1.0 + ERRORS * (20.0 / count).sqrt();
        mean_fits && squares / count <= expected * slack
    }
}

//! The filters of FLIP, each taken apart into rows and columns.

use super::PI;

/// Contrast sensitivity as sums of Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b),
/// x in degrees: pairs (a, b) of the paper's table.
const ACHROMATIC: (f64, f64) = (1.0, 0.0047);
const RED_GREEN: (f64, f64) = (1.0, 0.0053);
const BLUE_YELLOW: [(f64, f64); 2] = [(34.1, 0.04), (13.5, 0.025)];

/// Width in degrees of the lines that an eye is best at, the paper's w.
const FEATURE_WIDTH: f64 = 0.082;

/// Standard deviations at which a filter ends.
const DEVIATIONS: f64 = 3.0;

/// Filters for one viewing distance; each has an odd length, its middle counts.
pub(super) struct Filters {
    pub achromatic: Vec<f64>,
    pub red_green: Vec<f64>,
    /// Two Gaussians, whose sum cannot be taken apart into rows and columns.
    pub blue_yellow: [Vec<f64>; 2],
    /// The weight of each in two dimensions.
    pub blue_yellow_weights: [f64; 2],
    /// A Gaussian for features, and its first and second derivative.
    pub smooth: Vec<f64>,
    pub slope: Vec<f64>,
    pub bend: Vec<f64>,
    /// Half the length of the longest.
    pub reach: usize,
}

impl Filters {
    pub fn new(pixels_per_degree: f64) -> Self {
        // exp(-pi^2 x^2 / b) has the variance b / (2 pi^2); the widest of the
        // Gaussians sets the radius of all.
        let widest = (BLUE_YELLOW[0].1 / (2.0 * PI * PI)).sqrt();
        let radius = (DEVIATIONS * widest * pixels_per_degree).ceil() as usize;
        let sensitivity = |(_, b): (f64, f64)| {
            sampled(radius, |x| {
                (-PI * PI * (x / pixels_per_degree).powi(2) / b).exp()
            })
        };
        let blue_yellow = BLUE_YELLOW.map(sensitivity);
        // In two dimensions a Gaussian sums up to the square of its sum.
        let [first, second] = [0, 1].map(|i| {
            let (a, b) = BLUE_YELLOW[i];
            a * (PI / b).sqrt() * blue_yellow[i].iter().sum::<f64>().powi(2)
        });

        let deviation = 0.5 * FEATURE_WIDTH * pixels_per_degree;
        let feature_radius = (DEVIATIONS * deviation).ceil() as usize;
        let gauss = |x: f64| (-x * x / (2.0 * deviation * deviation)).exp();
        let slope = sampled(feature_radius, |x| -x * gauss(x));
        let bend = sampled(feature_radius, |x| {
            (x * x / (deviation * deviation) - 1.0) * gauss(x)
        });
        Self {
            achromatic: summing_to_one(sensitivity(ACHROMATIC)),
            red_green: summing_to_one(sensitivity(RED_GREEN)),
            blue_yellow: blue_yellow.map(summing_to_one),
            blue_yellow_weights: [first, second].map(|w| w / (first + second)),
            smooth: summing_to_one(sampled(feature_radius, gauss)),
            slope: on_a_unit_scale(balanced(slope)),
            bend: on_a_unit_scale(balanced(bend)),
            reach: radius.max(feature_radius),
        }
    }
}

fn sampled(radius: usize, f: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..=2 * radius)
        .map(|i| f(i as f64 - radius as f64))
        .collect()
}

fn summing_to_one(filter: Vec<f64>) -> Vec<f64> {
    let sum: f64 = filter.iter().sum();
    filter.into_iter().map(|w| w / sum).collect()
}

/// The positive weights sum to 1 and the negative ones to -1.
fn balanced(filter: Vec<f64>) -> Vec<f64> {
    let positive: f64 = filter.iter().filter(|w| **w > 0.0).sum();
    let negative: f64 = filter.iter().filter(|w| **w < 0.0).sum();
    let scale = |w: f64| if w > 0.0 { w / positive } else { w / -negative };
    filter.into_iter().map(scale).collect()
}

/// Features are sought in Y / 116, which is 0..=1.
fn on_a_unit_scale(filter: Vec<f64>) -> Vec<f64> {
    filter.into_iter().map(|w| w / 116.0).collect()
}

/// Appends one filtered row to a plane; `padded` is the row with `reach` more
/// values at either end.
pub(super) fn convolve_row(
    padded: &[f64],
    width: usize,
    reach: usize,
    filter: &[f64],
    plane: &mut Vec<f64>,
) {
    let start = plane.len();
    plane.resize(start + width, 0.0);
    let first = reach - filter.len() / 2;
    for (shift, weight) in filter.iter().enumerate() {
        add_scaled(&mut plane[start..], &padded[first + shift..], *weight);
    }
}

/// One row of a plane, filtered along the columns; `row` counts the plane's own
/// rows, of which there are enough above and below.
pub(super) fn convolve_column(plane: &[f64], width: usize, row: usize, filter: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; width];
    let first = row - filter.len() / 2;
    for (shift, weight) in filter.iter().enumerate() {
        add_scaled(&mut out, &plane[(first + shift) * width..], *weight);
    }
    out
}

fn add_scaled(out: &mut [f64], values: &[f64], weight: f64) {
    for (out, value) in out.iter_mut().zip(values) {
        *out += weight * value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_and_sums_at_67_pixels_a_degree() {
        let f = Filters::new(67.0);
        // 3 sqrt(0.04 / 2 pi^2) 67 = 9.05, 3 * 0.5 * 0.082 * 67 = 8.24.
        assert_eq!((f.achromatic.len(), f.smooth.len(), f.reach), (21, 19, 10));
        // At most 21 roundings of numbers up to 1.
        let close = |a: f64, b: f64| (a - b).abs() <= 21.0 * f64::EPSILON;
        for filter in [&f.achromatic, &f.red_green, &f.blue_yellow[0], &f.smooth] {
            assert!(close(filter.iter().sum(), 1.0));
        }
        assert!(close(f.blue_yellow_weights.iter().sum(), 1.0));
        for filter in [&f.slope, &f.bend] {
            let positive: f64 = filter.iter().filter(|w| **w > 0.0).sum();
            assert!(close(filter.iter().sum(), 0.0));
            assert!(close(positive, 1.0 / 116.0));
        }
    }
}

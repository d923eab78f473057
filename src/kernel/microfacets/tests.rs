//! The distribution, the masking and the sampling agree with what defines them.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::*;
use crate::kernel::mirror::mirrored;
use crate::random::Numbers;

/// Of each rounding, in parts of the number.
const ROUNDING: f64 = 1.0 / (1 << 24) as f64;

/// Standard deviations that chance does not reach: in one of a million tries or so.
const FAR: f64 = 5.0;

/// From the least to the largest.
const WIDTHS: [f32; 6] = [1.0 / 1024.0, 0.01, 0.09, 0.25, 0.5, 1.0];

fn tilted(cosine: f64, turn: f64) -> Vec3<f32> {
    let sine = (1.0 - cosine * cosine).sqrt();
    let angle = TAU * turn;
    let [x, y] = [sine * angle.cos(), sine * angle.sin()];
    vec3(x as f32, y as f32, cosine as f32)
}

/// By slopes, the distribution is that of Trowbridge and Reitz: 1 / (pi w^2 (1 + s^2 / w^2)^2).
#[test]
fn normals_are_distributed_by_their_slopes() {
    let mut worst: f64 = 0.0;
    for width in WIDTHS {
        for slope in [0.0, 1e-3, 0.01, 0.1, 0.5, 1.0, 3.0, 100.0] {
            for length in [1e-3f32, 1.0, 100.0] {
                let [x, y] = [(0.6 * slope) as f32, (0.8 * slope) as f32];
                let found = f64::from(density_of_normals(vec3(x, y, 1.0) * length, width));
                let width = f64::from(width);
                let by_slopes = 1.0 / (width * (1.0 + (slope / width).powi(2))).powi(2);
                // From slopes to solid angles and projected area: by the cosine to the fourth.
                let expected = by_slopes * (1.0 + slope * slope).powi(2);
                worst = worst.max((found / expected - 1.0).abs());
            }
        }
    }
    // The quotient's parts are off by 5 roundings each, and it by one; then it is squared.
    assert!(worst < 24.0 * ROUNDING, "{worst:e}");
    // The control: the textbook's form, of 1 less the square of the cosine.
    let (width, slope) = (1.0f32 / 1024.0, 1e-3f32);
    let cosine = 1.0 / (1.0 + slope * slope).sqrt();
    let square = width * width;
    let plain = square / (cosine * cosine * (square - 1.0) + 1.0).powi(2);
    let exact = density_of_normals(vec3(slope, 0.0, 1.0), width);
    assert!((plain / exact - 1.0).abs() > 1e-3);
}

/// What the small mirrors show together, those in front of others left out, is as large as the
/// surface looks: the mean of what each shows, over all slopes, is (cos + root) / 2 (Smith).
#[test]
fn masking_leaves_what_the_surface_shows() {
    for width in WIDTHS.map(f64::from) {
        for cosine in [0.001, 0.03, 0.3, 0.7, 1.0] {
            let sine = (1.0f64 - cosine * cosine).sqrt();
            let mean = |count: u32| {
                let mut sum = 0.0;
                for (radial, turning) in grid(count) {
                    // Evenly by area in the sphere of which the slopes are the projection.
                    let angle = FRAC_PI_2 * (1.0 - radial * radial);
                    let share = (2.0 * angle).sin() * FRAC_PI_2 * 2.0 * radial;
                    let slope = width * angle.tan();
                    let shown = sine * slope * (PI * turning).cos() + cosine;
                    sum += share * shown.max(0.0);
                }
                sum / f64::from(count * count)
            };
            let [coarse, fine] = [256, 512].map(mean);
            let found = masking_root(cosine as f32, width as f32);
            let expected = 2.0 * fine - cosine;
            // The rule's error falls with the square of its step: what is left is a third of
            // the change.
            let most = 2.0 * (fine - coarse).abs() + 8.0 * ROUNDING;
            assert!(
                (f64::from(found) - expected).abs() < most && most < 2e-3,
                "{width}, {cosine}: {found}, {expected}, {most:e}"
            );
        }
    }
}

/// The middles of the cells of a square.
fn grid(count: u32) -> impl Iterator<Item = (f64, f64)> {
    let at = move |step: u32| (f64::from(step) + 0.5) / f64::from(count);
    (0..count).flat_map(move |x| (0..count).map(move |y| (at(x), at(y))))
}

/// A rough mirror is as bright one way as the other way round.
#[test]
fn lobes_are_reciprocal() {
    let mut random = Numbers(5);
    for width in WIDTHS {
        for _ in 0..1000 {
            let [view, light] =
                [0; 2].map(|_| tilted(random.between(0.01, 1.0), random.between(0.0, 1.0)));
            let there = shape_of_lobe(view, light, width) * lit_by_cosine(view, light, width);
            let back = shape_of_lobe(light, view, width) * lit_by_cosine(light, view, width);
            // Some two dozen roundings on each side.
            let most = 50.0 * ROUNDING as f32 * there;
            assert!((there - back).abs() <= most, "{there} {back}");
        }
    }
}

/// Bins of directions: evenly by height above the surface, and by turns.
const BINS: [usize; 2] = [6, 8];

/// The bin of a direction above the surface.
fn bin_of(light: Vec3<f32>) -> usize {
    let turn = f64::from(light.y).atan2(f64::from(light.x)) / TAU + 0.5;
    let bin = |at: f64, bins: usize| ((at * bins as f64) as usize).min(bins - 1);
    bin(f64::from(light.z), BINS[0]) * BINS[1] + bin(turn, BINS[1])
}

/// How many of `count` mirrored directions are to be in each bin, and below the surface last.
fn expected_counts(view: Vec3<f32>, width: f32, count: f64) -> Vec<f64> {
    let cells = 480;
    let mut bins = vec![0.0; BINS[0] * BINS[1] + 1];
    for (height, turn) in grid(cells) {
        let light = tilted(height, turn);
        let share = TAU / f64::from(cells * cells);
        let density = f64::from(shape_of_lobe(view, light, width)) / PI;
        bins[bin_of(light)] += density * share * count;
    }
    let above: f64 = bins.iter().sum();
    *bins.last_mut().unwrap() = count - above;
    bins
}

/// Pearson's sum, by what it is to be and its standard deviation, of bins that hold enough.
fn surprise(found: &[f64], expected: &[f64]) -> f64 {
    let (mut sum, mut freedom) = (0.0, -1.0);
    for (found, expected) in found.iter().zip(expected) {
        if *expected > 20.0 {
            sum += (found - expected).powi(2) / expected;
            freedom += 1.0;
        }
    }
    (sum - freedom) / (2.0f64 * freedom).sqrt()
}

/// Directions are drawn with the density that is told of them.
#[test]
fn directions_are_drawn_as_their_density_says() {
    let count = 100_000;
    let mut random = Numbers(7);
    for width in [0.25f32, 0.5, 1.0] {
        for cosine in [0.1, 0.5, 0.9] {
            let view = tilted(cosine, 0.3);
            let mut found = vec![0.0; BINS[0] * BINS[1] + 1];
            for _ in 0..count {
                let pair = [0; 2].map(|_| random.between(0.0, 1.0) as f32);
                let light = mirrored(-view, visible_normal(view, width, pair));
                let bin = if light.z > 0.0 {
                    bin_of(light)
                } else {
                    found.len() - 1
                };
                found[bin] += 1.0;
            }
            let expected = expected_counts(view, width, f64::from(count));
            let surprise = |expected| surprise(&found, expected);
            let plain = surprise(&expected);
            assert!(plain < FAR, "{width}, {cosine}: {plain}");
            // The control: another width's density.
            let other = surprise(&expected_counts(view, width * 0.9, f64::from(count)));
            assert!(other > FAR, "{width}, {cosine}: {other}");
        }
    }
}

/// At the edges of all ranges there are numbers, and normals that are seen.
#[test]
fn nothing_but_numbers_comes_out() {
    let least = 1.0 / (1u32 << 20) as f32;
    let last = 1.0 - 1.0 / 16_777_216.0;
    for width in WIDTHS {
        for z in [least, 1e-3, 0.5, 1.0f32] {
            let view = vec3((1.0 - z * z).sqrt(), 0.0, z);
            for a in [0.0, 0.25, 0.5, last] {
                for b in [0.0, 1e-7, 0.5, 1.0 - 1e-4, last] {
                    let normal = visible_normal(view, width, [a, b]);
                    assert!((0.0..=1.001).contains(&normal.z), "{normal:?}");
                    let mut light = mirrored(-view, normal);
                    // Where only roundings are left of it, it may be turned away: then its
                    // light comes from below.
                    let seen = dot_product(view, normal);
                    assert!(seen >= 0.0 || light.z <= 0.0, "{view:?} {normal:?}");
                    if light.z <= 0.0 {
                        light.z = 1e-30;
                    }
                    let shape = shape_of_lobe(view, light, width);
                    let lit = lit_by_cosine(view, light, width);
                    assert!((0.0..1e9).contains(&shape), "{view:?} {light:?}: {shape}");
                    assert!(lit > 0.0 && lit < 1e9, "{view:?} {light:?}: {lit}");
                    // What a path brings of its light: never more than there is.
                    assert!(light.z * lit <= 1.0 + 8.0 * ROUNDING as f32);
                }
            }
        }
    }
}

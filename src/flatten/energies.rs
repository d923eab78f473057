//! What of light a rough mirror would throw back that threw back all.
//!
//! The mean over the small mirrors' slopes of what of each is lit, and seen by who looks: Heitz,
//! "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014.
//! The slopes whose mirrors throw light to above the surface are those of a circle.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::kernel::glossy::ENERGIES;
use crate::layout::FinishRecord;

/// Points of the quadrature along a radius of the slopes, and along a quarter of a turn: with
/// them it is off by some 1e-5, see the tests.
const POINTS: [usize; 2] = [16, 12];

/// A row for each width of the rough ones of these, and in each of them its row.
pub(super) fn energies(finishes: &mut [FinishRecord]) -> Vec<f32> {
    let points = POINTS.map(gauss_points);
    let mut widths: Vec<f32> = Vec::new();
    let mut energies = Vec::new();
    for finish in finishes.iter_mut().filter(|finish| finish.is_rough()) {
        let known = widths.iter().position(|width| *width == finish.width);
        finish.energies = known.unwrap_or(widths.len()) as u32;
        if known.is_none() {
            widths.push(finish.width);
            let width = f64::from(finish.width);
            energies.extend((0..ENERGIES).map(|place| {
                let cosine = cosine_of_place(f64::from(place), width);
                energy(cosine, width, &points) as f32
            }));
        }
    }
    energies
}

/// Undoes [`crate::kernel::glossy::place_of_energy`].
fn cosine_of_place(place: f64, width: f64) -> f64 {
    let part = (place / f64::from(ENERGIES - 1)).powi(2);
    let twice = 2.0 * width;
    part * twice / (1.0 + twice - part)
}

/// The energy of a width, seen at a cosine of 0 to 1.
fn energy(cosine: f64, width: f64, points: &[Vec<[f64; 2]>; 2]) -> f64 {
    // What grazes the surface meets it in mirrors that stand so that all goes up.
    if cosine == 0.0 {
        return 1.0;
    }
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let root = |c: f64| (width * width + (1.0 - width * width) * c * c).sqrt();
    let seen = root(cosine);
    let [radial, turning] = points;
    let mut sum = 0.0;
    for [turn, share] in turning {
        for side in [1.0, -1.0] {
            // Towards the viewer, and away; most points are near what is across.
            let towards = side * (FRAC_PI_2 * turn * turn).sin();
            let middle = sine / cosine * towards;
            let half = (middle * middle + 1.0).sqrt();
            let limit = if side > 0.0 {
                middle + half
            } else {
                1.0 / (half - middle)
            };
            // A slope is the width times the tangent of an angle; most points are near the limit.
            let end = (limit / width).atan();
            for [part, weight] in radial {
                let angle = end * (1.0 - part.powi(3));
                let slope = width * angle.tan();
                let facing = sine * slope * towards + cosine;
                let lit = 2.0 * facing / (1.0 + slope * slope) - cosine;
                // By roundings, at the limit.
                if lit <= 0.0 {
                    continue;
                }
                let thrown = 2.0 * facing * lit / (lit * seen + cosine * root(lit));
                let density = (2.0 * angle).sin() * end * 3.0 * part * part;
                sum += (share * turn) * (weight * density) * thrown;
            }
        }
    }
    sum
}

/// Where, from 0 to 1, to take a function for the sum of its values times these weights to be
/// its integral, exactly for polynomials of a degree below twice the number of points.
///
/// Gauss's points: the zeros of Legendre's polynomial, by Newton's method.
fn gauss_points(count: usize) -> Vec<[f64; 2]> {
    let degree = count as f64;
    let point = |index: usize| {
        let mut x = (PI * (index as f64 + 0.75) / (degree + 0.5)).cos();
        let mut slope = 1.0;
        // It is right to 4 digits to begin with, and their number doubles.
        for _ in 0..4 {
            let (mut value, mut last) = (1.0, 0.0);
            for k in (0..count).map(|k| k as f64) {
                (value, last) = (((2.0 * k + 1.0) * x * value - k * last) / (k + 1.0), value);
            }
            slope = degree * (x * value - last) / (x * x - 1.0);
            x -= value / slope;
        }
        [0.5 * (x + 1.0), 1.0 / ((1.0 - x * x) * slope * slope)]
    };
    (0..count).map(point).collect()
}

#[cfg(test)]
mod tests;

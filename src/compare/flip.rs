//! LDR-FLIP, an error map close to what a person sees who alternates between
//! two pictures: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom,
//! Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM
//! CGIT 3(2), 2020, doi 10.1145/3406183. Written from the paper.

use std::f64::consts::{PI, SQRT_2};

use glam::DVec3;
use rayon::prelude::*;

use crate::color::{lab_from_rgb, rgb_from_ycxcz, ycxcz_from_rgb};
use filters::{Filters, convolve_column, convolve_row};

mod filters;

/// A 4K screen 0.7 m wide, seen from 0.7 m: the paper's default.
pub const PIXELS_PER_DEGREE: f64 = 67.0;

/// The paper's q_c and q_f: exponents of the colour and the feature difference.
const COLOR_EXPONENT: f64 = 0.7;
const FEATURE_EXPONENT: f64 = 0.5;

/// The paper's p_c and p_t: colour differences up to this part of the greatest
/// take up this part of the scale.
const COMPRESSED_FROM: f64 = 0.4;
const COMPRESSED_TO: f64 = 0.95;

/// Rows that one task filters. More rows waste less on the rows above and
/// below that two tasks both need, fewer spread better over threads.
const BAND: usize = 64;

/// The FLIP error of every pixel, 0..=1, for pictures of linear RGB in 0..=1,
/// `width * height` pixels each, row by row. Symmetric; 0 where the
/// surroundings are equal. Beyond the border the outermost pixels repeat.
/// `pixels_per_degree` is how many pixels an observer sees in a degree of the
/// visual angle; it is held to 1..=1000, so that the filters stay finite.
///
/// # Panics
/// Where a picture has not `width * height` pixels.
pub fn error_map(
    left: &[[f32; 3]],
    right: &[[f32; 3]],
    width: usize,
    height: usize,
    pixels_per_degree: f64,
) -> Vec<f32> {
    assert_eq!(left.len(), width * height);
    assert_eq!(right.len(), width * height);
    let filters = Filters::new(pixels_per_degree.clamp(1.0, 1000.0));
    let greatest = greatest_color_difference();
    let mut errors = vec![0.0; width * height];
    if left == right {
        return errors;
    }
    let bands = errors.par_chunks_mut(BAND * width).enumerate();
    bands.for_each(|(band, errors)| {
        let rows = band * BAND..(band * BAND + errors.len() / width);
        let left = Seen::of(left, width, height, rows.clone(), &filters);
        let right = Seen::of(right, width, height, rows, &filters);
        for (i, error) in errors.iter_mut().enumerate() {
            let color = color_error(left.color[i], right.color[i], greatest);
            let feature = feature_error(&left, &right, i);
            *error = color.powf(1.0 - feature) as f32;
        }
    });
    errors
}

/// The mean of an error map, summed in one order; 0 for an empty one.
pub fn mean(errors: &[f32]) -> f64 {
    let sum: f64 = errors.iter().map(|e| f64::from(*e)).sum();
    sum / errors.len().max(1) as f64
}

/// What an observer sees of some rows of a picture.
struct Seen {
    /// L*a*b* after the contrast sensitivity filter, with Hunt's adjustment.
    color: Vec<DVec3>,
    /// Strength of edges and of points.
    edge: Vec<f64>,
    point: Vec<f64>,
}

/// One picture's rows through the row filters; one plane for each filter.
#[derive(Default)]
struct Planes {
    y: Vec<f64>,
    cx: Vec<f64>,
    cz: [Vec<f64>; 2],
    smooth: Vec<f64>,
    slope: Vec<f64>,
    bend: Vec<f64>,
}

impl Seen {
    fn of(
        image: &[[f32; 3]],
        width: usize,
        height: usize,
        rows: std::ops::Range<usize>,
        f: &Filters,
    ) -> Self {
        let planes = filter_rows(image, width, height, &rows, f);
        let mut seen = Self {
            color: Vec::with_capacity(rows.len() * width),
            edge: Vec::with_capacity(rows.len() * width),
            point: Vec::with_capacity(rows.len() * width),
        };
        let column = |plane: &[f64], row, filter: &[f64]| {
            convolve_column(plane, width, row + f.reach, filter)
        };
        for row in 0..rows.len() {
            let y = column(&planes.y, row, &f.achromatic);
            let cx = column(&planes.cx, row, &f.red_green);
            let cz = [0, 1].map(|i| column(&planes.cz[i], row, &f.blue_yellow[i]));
            let slope_x = column(&planes.slope, row, &f.smooth);
            let slope_y = column(&planes.smooth, row, &f.slope);
            let bend_x = column(&planes.bend, row, &f.smooth);
            let bend_y = column(&planes.smooth, row, &f.bend);
            for x in 0..width {
                let cz = f.blue_yellow_weights[0] * cz[0][x] + f.blue_yellow_weights[1] * cz[1][x];
                seen.color.push(hunt_lab(DVec3::new(y[x], cx[x], cz)));
                seen.edge.push(slope_x[x].hypot(slope_y[x]));
                seen.point.push(bend_x[x].hypot(bend_y[x]));
            }
        }
        seen
    }
}

/// The band's rows and those in reach above and below it.
fn filter_rows(
    image: &[[f32; 3]],
    width: usize,
    height: usize,
    rows: &std::ops::Range<usize>,
    f: &Filters,
) -> Planes {
    let mut planes = Planes::default();
    let mut padded = [(); 3].map(|()| vec![0.0; width + 2 * f.reach]);
    for row in 0..rows.len() + 2 * f.reach {
        let y = (rows.start + row).saturating_sub(f.reach).min(height - 1);
        for at in 0..width + 2 * f.reach {
            let x = at.saturating_sub(f.reach).min(width - 1);
            let ycxcz = ycxcz_from_rgb(image[y * width + x].map(f64::from).into());
            for (channel, padded) in padded.iter_mut().enumerate() {
                padded[at] = ycxcz[channel];
            }
        }
        let [y, cx, cz] = &padded;
        let filter = |channel: &[f64], filter: &[f64], plane: &mut Vec<f64>| {
            convolve_row(channel, width, f.reach, filter, plane);
        };
        filter(y, &f.achromatic, &mut planes.y);
        filter(cx, &f.red_green, &mut planes.cx);
        filter(cz, &f.blue_yellow[0], &mut planes.cz[0]);
        filter(cz, &f.blue_yellow[1], &mut planes.cz[1]);
        filter(y, &f.smooth, &mut planes.smooth);
        filter(y, &f.slope, &mut planes.slope);
        filter(y, &f.bend, &mut planes.bend);
    }
    planes
}

/// Colour pipeline: what a display can show of a filtered colour, as L*a*b* with
/// Hunt's adjustment, by which colours weaken with lightness.
fn hunt_lab(ycxcz: DVec3) -> DVec3 {
    hunt(rgb_from_ycxcz(ycxcz).clamp(DVec3::ZERO, DVec3::ONE))
}

fn hunt(rgb: DVec3) -> DVec3 {
    let lab = lab_from_rgb(rgb);
    DVec3::new(lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z)
}

/// HyAB, the distance for large colour differences: city blocks in lightness,
/// Euclid in chroma.
fn hyab(a: DVec3, b: DVec3) -> f64 {
    let d = a - b;
    d.x.abs() + d.y.hypot(d.z)
}

/// Green and blue are farther apart than any two colours of a display.
fn greatest_color_difference() -> f64 {
    hyab(hunt(DVec3::Y), hunt(DVec3::Z)).powf(COLOR_EXPONENT)
}

/// Colour pipeline: the difference, compressed so that the large ones
/// share the top of the scale.
fn color_error(a: DVec3, b: DVec3, greatest: f64) -> f64 {
    let difference = hyab(a, b).powf(COLOR_EXPONENT);
    let knee = COMPRESSED_FROM * greatest;
    if difference < knee {
        COMPRESSED_TO / knee * difference
    } else {
        let above = (difference - knee) / (greatest - knee);
        (COMPRESSED_TO + above * (1.0 - COMPRESSED_TO)).min(1.0)
    }
}

/// Feature pipeline: how much an edge or a point is stronger on one side.
fn feature_error(a: &Seen, b: &Seen, i: usize) -> f64 {
    let edge = (a.edge[i] - b.edge[i]).abs();
    let point = (a.point[i] - b.point[i]).abs();
    (edge.max(point) / SQRT_2).powf(FEATURE_EXPONENT).min(1.0)
}

#[cfg(test)]
mod tests;

//! The environment: its texels, and the sums by which directions are drawn as bright as they
//! are.
//!
//! All directions are divided into cells of the same solid angle, the columns by azimuth, the
//! rows by height. A cell is drawn by the light in it. Whatever the weights, the mean of what
//! is found is right as long as no cell with light in it has none; they only keep the noise
//! low.

use std::ops::Range;
use std::sync::Arc;

use crate::flat::SkyTables;
use crate::kernel::numbers::STEP;
use crate::kernel::sky::{COLUMNS, ROWS};
use crate::kernel::tally::LUMINANCE;
use crate::layout::Environment;
use crate::scene::{Background, Rgb, Sky, Texels};

use super::color;

/// Cells are drawn at least with this part of the mean cell's weight, so that directions are
/// found whose light is overlooked. A draw in so many is spent on it.
const FLOOR: f64 = 1.0 / 64.0;

/// Heights at which a ramp is looked at in a row of cells.
const LOOKS: usize = 16;

/// The record and the tables of an environment.
pub(super) fn flatten_sky(around: &crate::scene::Environment) -> (Environment, Arc<SkyTables>) {
    let intensity = around.intensity;
    let scaled = |rgb: Rgb| rgb.map(|channel| channel * intensity);
    match &around.sky {
        Sky::Gradient(ramp) => {
            let ramp = Background {
                from: scaled(ramp.from),
                to: scaled(ramp.to),
                ..*ramp
            };
            let record = Environment {
                start: color(ramp.from),
                offset: ramp.offset as f32,
                end: color(ramp.to),
                slope: ramp.slope as f32,
                count: 1,
                ..Environment::default()
            };
            let tables = SkyTables {
                texels: Vec::new(),
                sums: sums_of(&ramp_weights(&ramp)),
            };
            (record, Arc::new(tables))
        }
        Sky::Image(image) => {
            // The left edge is half a turn from x.
            let turn = (0.5 + around.turn_degrees / 360.0).rem_euclid(1.0) as f32;
            let record = Environment {
                turn: if turn < 1.0 { turn } else { 0.0 },
                width: image.width,
                height: image.height,
                count: 1,
                ..Environment::default()
            };
            let texel = |[r, g, b, _]: &[f32; 4]| {
                let [r, g, b] = color(scaled([*r, *g, *b].map(f64::from)));
                [r, g, b, 0.0]
            };
            let tables = SkyTables {
                texels: image.texels.iter().map(texel).collect(),
                sums: sums_of(&image_weights(image)),
            };
            (record, Arc::new(tables))
        }
    }
}

/// How bright a colour is.
fn luminance([r, g, b]: Rgb) -> f64 {
    let [x, y, z] = [LUMINANCE.x, LUMINANCE.y, LUMINANCE.z].map(f64::from);
    x * r + y * g + z * b
}

/// The light in each cell, row by row from the top.
fn ramp_weights(ramp: &Background) -> Vec<f64> {
    let weight = |look: usize| {
        let height = 1.0 - (look as f64 + 0.5) * 2.0 / (ROWS as usize * LOOKS) as f64;
        let weight = ramp.offset + ramp.slope * height;
        let [from, to] = [ramp.from, ramp.to].map(luminance);
        // A ramp may go below 0.
        (from * (1.0 - weight) + to * weight).abs()
    };
    (0..ROWS as usize)
        .map(|row| (row * LOOKS..(row + 1) * LOOKS).map(weight).sum())
        .flat_map(|weight| [weight; COLUMNS as usize])
        .collect()
}

/// The same of an image. Between the middles of texels light is interpolated, so that of
/// each texel reaches half a texel beyond it: it counts as spread evenly so far.
fn image_weights(image: &Texels) -> Vec<f64> {
    let (width, height) = (image.width as usize, image.height as usize);
    let columns: Vec<_> = (0..width)
        .map(|x| {
            let spread = [x as f64 - 0.5, x as f64 + 1.5].map(|edge| edge / width as f64);
            overlaps(spread.map(|edge| edge * f64::from(COLUMNS)))
        })
        .collect();
    let mut weights = vec![0.0; (COLUMNS * ROWS) as usize];
    // Beyond the poles light goes on as it is there.
    for y in -1..=height as i64 {
        let first = y.clamp(0, height as i64 - 1) as usize * width;
        let texels = &image.texels[first..first + width];
        let mut line = vec![0.0; COLUMNS as usize];
        for (texel, columns) in texels.iter().zip(&columns) {
            let light = luminance([texel[0], texel[1], texel[2]].map(f64::from));
            for (column, part) in columns {
                line[column.rem_euclid(i64::from(COLUMNS)) as usize] += light * part;
            }
        }
        let edges = [y as f64 - 0.5, y as f64 + 1.5].map(|edge| {
            let turn = (edge / height as f64).clamp(0.0, 1.0);
            let height = (std::f64::consts::PI * turn).cos();
            (1.0 - height) / 2.0 * f64::from(ROWS)
        });
        for (row, part) in overlaps(edges) {
            let first = row.min(i64::from(ROWS) - 1) as usize * COLUMNS as usize;
            let cells = &mut weights[first..first + COLUMNS as usize];
            for (cell, light) in cells.iter_mut().zip(&line) {
                *cell += light * part;
            }
        }
    }
    weights
}

/// The unit steps that a stretch meets, and how much of each.
fn overlaps([begin, end]: [f64; 2]) -> Vec<(i64, f64)> {
    let steps: Range<i64> = begin.floor() as i64..end.ceil() as i64;
    let part = |step: i64| end.min(step as f64 + 1.0) - begin.max(step as f64);
    steps.map(|step| (step, part(step))).collect()
}

/// The sums by which cells are drawn: of the rows, then of the cells of each row.
fn sums_of(weights: &[f64]) -> Vec<f32> {
    let least = weights.iter().sum::<f64>() / weights.len() as f64 * FLOOR;
    // In the dark all are alike.
    let least = if least > 0.0 { least } else { 1.0 };
    let rows: Vec<Vec<f64>> = weights
        .chunks(COLUMNS as usize)
        .map(|row| row.iter().map(|weight| weight + least).collect())
        .collect();
    let of_rows: Vec<f64> = rows.iter().map(|row| row.iter().sum()).collect();
    let mut sums = partial_sums(&of_rows);
    sums.extend(rows.iter().flat_map(|row| partial_sums(row)));
    sums
}

/// Before each weight, the sum of those before it as a part of all: a multiple of
/// [`STEP`], as the numbers are by which it is drawn, so that its part is just as many of
/// them. Each has one at least.
fn partial_sums(weights: &[f64]) -> Vec<f32> {
    let steps = f64::from(1.0 / STEP);
    let whole: f64 = weights.iter().sum();
    let (mut sum, mut least) = (0.0, 0.0);
    let mut sums = Vec::with_capacity(weights.len());
    for (weight, after) in weights.iter().zip((0..weights.len()).rev()) {
        let most = steps - 1.0 - after as f64;
        let place = (sum / whole * steps).round().clamp(least, most);
        sums.push((place / steps) as f32);
        least = place + 1.0;
        sum += weight;
    }
    sums
}

#[cfg(test)]
mod tests;

//! An environment that shines from all sides.
//!
//! Where light is searched for in it, directions are drawn by cells of the same solid angle,
//! as likely as they are bright: Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th
//! edition, 12.5.2. How the cells and their sums come about is in `src/flatten/sky.rs`.

use super::angles::{polar_turn, turn_of};
use super::background::background_color;
use super::circle::circle_point;
use super::dimensions::{SKY, dimension_of};
use super::divide::{divide, square_root};
use super::hit::Surface;
use super::integrator::Path;
use super::numbers::{STEP, number_pair};
use super::real::Real;
use super::sources::{Arriving, ENDLESS, found_weight, nothing_arriving};
use super::vector::{Vec3, divided, unit_vector, vec3};
use crate::flat::Flat;

/// Cells in a row: all azimuths. A power of 2.
pub const COLUMNS: u32 = 256;

/// Rows of cells, the first around the zenith: all heights. A power of 2.
pub const ROWS: u32 = 128;

/// The number of cells over 4 pi: the density of directions, by solid angle, where all are as
/// likely, in units of a cell's chance.
pub const CELL_DENSITY: f32 = 2607.5945;

/// 1 / pi: what a surface looks like under so much light from the sky.
pub const SKY_PER_PI: f32 = std::f32::consts::FRAC_1_PI;

/// A cell of directions, and where in it one is.
#[derive(Debug, Clone, Copy)]
struct Draw {
    /// The number of the row, or of the cell in it.
    index: u32,
    /// From one edge to the other: 0 to 1.
    place: f32,
    /// The chance of being drawn.
    chance: f32,
}

/// How many skies there are: one or none.
pub fn count_skies<R>(flat: &Flat<R>) -> u32 {
    flat.environment.count
}

/// What a whole turn more or less leaves of a turn: from 0 up to but not 1.
fn within_turn(turn: f32) -> f32 {
    if turn < 0.0 {
        let more = turn + 1.0;
        return if more < 1.0 { more } else { 0.0 };
    }
    if turn >= 1.0 { turn - 1.0 } else { turn }
}

/// How far a direction is from the image's left edge, in turns.
fn turn_in_image<R>(flat: &Flat<R>, direction: Vec3<f32>) -> f32 {
    within_turn(turn_of(direction.x, direction.z) + flat.environment.turn)
}

/// The radiance of an image in a direction of unit length: between the middles of texels
/// that of the four around.
fn image_radiance<R>(flat: &Flat<R>, direction: Vec3<f32>) -> Vec3<f32> {
    let (width, height) = (flat.environment.width, flat.environment.height);
    let across = turn_in_image(flat, direction) * width as f32 - 0.5;
    let down = polar_turn(direction.y) * height as f32 - 0.5;
    let left = across.floor();
    let top = down.floor();
    // The left edge and the right edge meet; beyond the poles there is nothing.
    let x0 = if left < 0.0 { width - 1 } else { left as u32 };
    let x1 = if x0 + 1 < width { x0 + 1 } else { 0 };
    let y0 = if top < 0.0 { 0 } else { top as u32 };
    let below = (top + 1.0) as u32;
    let y1 = if below < height { below } else { height - 1 };
    let texel = |x: u32, y: u32| {
        let [r, g, b, _] = flat.sky.texels[(y * width + x) as usize];
        vec3(r, g, b)
    };
    let right = across - left;
    let upper = texel(x0, y0) * (1.0 - right) + texel(x1, y0) * right;
    let lower = texel(x0, y1) * (1.0 - right) + texel(x1, y1) * right;
    let low = down - top;
    upper * (1.0 - low) + lower * low
}

/// The radiance in a direction of unit length.
fn sky_radiance<R>(flat: &Flat<R>, direction: Vec3<f32>) -> Vec3<f32> {
    let environment = &flat.environment;
    if environment.width > 0 {
        return image_radiance(flat, direction);
    }
    let weight = environment.offset + environment.slope * direction.y;
    Vec3::from(environment.start) * (1.0 - weight) + Vec3::from(environment.end) * weight
}

/// The chance of one of `count` with the sums that begin at `first`.
fn chance_of<R>(flat: &Flat<R>, first: u32, count: u32, index: u32) -> f32 {
    let mut end = 1.0;
    if index + 1 < count {
        end = flat.sky.sums[(first + index + 1) as usize];
    }
    end - flat.sky.sums[(first + index) as usize]
}

/// Draws one of `count`, a power of 2, by a number: the last whose sum is not above it. The
/// number's place between two sums is used once more.
fn draw<R>(flat: &Flat<R>, first: u32, count: u32, number: f32) -> Draw {
    let mut index = 0;
    let mut half = count >> 1;
    while half > 0 {
        if flat.sky.sums[(first + index + half) as usize] <= number {
            index += half;
        }
        half >>= 1;
    }
    let chance = chance_of(flat, first, count, index);
    let above = number - flat.sky.sums[(first + index) as usize];
    Draw {
        index,
        place: divide(above + 0.5 * STEP, chance),
        chance,
    }
}

/// The density, by solid angle, with which a direction of unit length is drawn.
fn sky_density<R>(flat: &Flat<R>, direction: Vec3<f32>) -> f32 {
    let down = (1.0 - direction.y) * (0.5 * ROWS as f32);
    let across = turn_in_image(flat, direction) * COLUMNS as f32;
    let row = if down < 0.0 { 0 } else { down as u32 };
    let row = if row < ROWS { row } else { ROWS - 1 };
    let column = across as u32;
    let column = if column < COLUMNS {
        column
    } else {
        COLUMNS - 1
    };
    let of_row = chance_of(flat, 0, ROWS, row);
    let of_cell = chance_of(flat, ROWS + row * COLUMNS, COLUMNS, column);
    (of_row * of_cell) * CELL_DENSITY
}

/// What comes from the sky, by a direction drawn by its brightness.
pub fn arriving_from_sky<R: Real>(flat: &Flat<R>, path: &Path<R>, _surface: &Surface) -> Arriving {
    let pair = number_pair(path.numbers, dimension_of(path.leg, SKY));
    let row = draw(flat, 0, ROWS, pair[0]);
    let cell = draw(flat, ROWS + row.index * COLUMNS, COLUMNS, pair[1]);
    let density = (row.chance * cell.chance) * CELL_DENSITY;
    // The height less 1, so that nothing cancels near the poles.
    let lowered = (row.index as f32 + row.place) * (2.0 / ROWS as f32);
    let radius = square_root(lowered * (2.0 - lowered));
    let across = (cell.index as f32 + cell.place) * (1.0 / COLUMNS as f32);
    let point = circle_point(within_turn(across - flat.environment.turn));
    let direction = vec3(radius * point[0], 1.0 - lowered, radius * point[1]);
    Arriving {
        towards: direction,
        color: divided(sky_radiance(flat, direction) * SKY_PER_PI, density),
        goal: direction,
        is_far: true,
        limit: ENDLESS,
        density,
        ..nothing_arriving()
    }
}

/// What a path sees that meets nothing: of the environment, as much as is due to paths that
/// find it.
pub fn seen_sky<R: Real>(flat: &Flat<R>, path: &Path<R>) -> Vec3<f32> {
    let direction = path.ray.direction.to_f32();
    if flat.environment.count == 0 {
        return background_color(&flat.surroundings, direction);
    }
    let unit = unit_vector(direction);
    let radiance = sky_radiance(flat, unit);
    if path.density == 0.0 {
        return radiance;
    }
    radiance * found_weight(flat, path.density, sky_density(flat, unit))
}

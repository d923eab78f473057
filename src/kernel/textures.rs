//! Textures: the albedo from place to place.

use super::camera::Ray;
use super::divide::divide;
use super::hit::{Hit, Surface};
use super::real::Real;
use super::sphere_coordinates::sphere_coordinates;
use super::triangle_coordinates::triangle_coordinates;
use super::vector::{Vec3, vec3};
use crate::flat::Flat;
use crate::layout::{NONE, TextureRecord};

/// From here on an f32 has no digits behind the point, so that no place of a repeat is told.
pub const NO_FRACTION: f32 = 8_388_608.0;

/// How far within its repeat a coordinate is: from 0 to 1, where 1 is the rounding of what is
/// just below.
fn within_repeat(coordinate: f32) -> f32 {
    if coordinate.abs() >= NO_FRACTION {
        return 0.0;
    }
    coordinate - coordinate.floor()
}

/// The coordinates of a place in the world along the two axes that its surface lies most
/// along: from the side x and y, or z and y; from above x and z. In repeats.
fn box_coordinates(texture: &TextureRecord, surface: &Surface) -> [f32; 2] {
    let place = surface.position + Vec3::from(texture.offset);
    let facing = surface.facing;
    let along = vec3(facing.x.abs(), facing.y.abs(), facing.z.abs());
    let mut plane = [place.x, place.y];
    if along.x > along.y && along.x > along.z {
        plane[0] = place.z;
    } else if along.y > along.z {
        plane[1] = place.z;
    }
    [
        divide(plane[0], texture.size),
        divide(plane[1], texture.size),
    ]
}

/// Where on a texture a place lies, in repeats: by the coordinates of its shape, or where that
/// has none, by its own in the world.
pub fn texture_coordinates<R: Real>(
    flat: &Flat<R>,
    ray: Ray<R>,
    hit: Hit<R>,
    surface: &Surface,
    texture: &TextureRecord,
) -> [f32; 2] {
    let on_shape =
        sphere_coordinates(flat, hit, surface).or_else(|| triangle_coordinates(flat, ray, hit));
    match on_shape {
        Some([across, upward]) => [across * texture.repeat[0], upward * texture.repeat[1]],
        None => box_coordinates(texture, surface),
    }
}

/// A square of a checker: white where the repeat begins, by turns.
fn checker_color(texture: &TextureRecord, across: f32, upward: f32) -> [f32; 4] {
    if (across >= 0.5) == (upward >= 0.5) {
        return [1.0, 1.0, 1.0, 1.0];
    }
    let [red, green, blue] = texture.color;
    [red, green, blue, 1.0]
}

/// The number of a texel, of so many that repeat: one before the first is the last.
fn wrapped(index: i32, count: u32) -> u32 {
    if index < 0 {
        return count - 1;
    }
    if index as u32 >= count {
        0
    } else {
        index as u32
    }
}

/// From one colour to another, by a part of the way.
fn between(from: [f32; 4], to: [f32; 4], part: f32) -> [f32; 4] {
    [0, 1, 2, 3].map(|channel: usize| from[channel] + (to[channel] - from[channel]) * part)
}

/// An image between the middles of its texels: blended across and then down.
fn image_color<R>(flat: &Flat<R>, texture: &TextureRecord, across: f32, upward: f32) -> [f32; 4] {
    let right = across * texture.width as f32 - 0.5;
    let down = (1.0 - upward) * texture.height as f32 - 0.5;
    let column = right.floor();
    let row = down.floor();
    let first = wrapped(column as i32, texture.width);
    let second = wrapped(column as i32 + 1, texture.width);
    let upper = texture.first + wrapped(row as i32, texture.height) * texture.width;
    let lower = texture.first + wrapped(row as i32 + 1, texture.height) * texture.width;
    let texel = |index: u32| flat.texels[index as usize];
    let of_upper = between(texel(upper + first), texel(upper + second), right - column);
    let of_lower = between(texel(lower + first), texel(lower + second), right - column);
    between(of_upper, of_lower, down - row)
}

/// The colour of a texture, and its alpha, at these coordinates.
pub fn texture_color<R>(
    flat: &Flat<R>,
    texture: &TextureRecord,
    coordinates: [f32; 2],
) -> [f32; 4] {
    let across = within_repeat(coordinates[0]);
    let upward = within_repeat(coordinates[1]);
    if texture.width == 0 {
        return checker_color(texture, across, upward);
    }
    image_color(flat, texture, across, upward)
}

/// The albedo, times the texture of the place.
pub fn textured<R: Real>(
    flat: &Flat<R>,
    ray: Ray<R>,
    hit: Hit<R>,
    surface: &Surface,
    material: u32,
    albedo: Vec3<f32>,
) -> Vec3<f32> {
    let index = flat.finishes[material as usize].texture;
    if index == NONE {
        return albedo;
    }
    let texture = &flat.textures[index as usize];
    let coordinates = texture_coordinates(flat, ray, hit, surface, texture);
    let [red, green, blue, _] = texture_color(flat, texture, coordinates);
    albedo.times(vec3(red, green, blue))
}

//! Where on a texture a place of a sphere lies.

use super::angles::{polar_turn, turn_of};
use super::hit::{Hit, Surface};
use super::real::Real;
use super::sphere_rows::sphere_at;
use super::vector::{Vec3, dot_product};
use crate::flat::Flat;

/// The texture coordinates of the place where a sphere was hit: its longitude from -x by way
/// of +z, in turns, and its latitude from the lower pole, in half turns. So an image lies on
/// it as on a globe, its middle in +x. None of another shape.
pub fn sphere_coordinates<R: Real>(
    flat: &Flat<R>,
    hit: Hit<R>,
    surface: &Surface,
) -> Option<[f32; 2]> {
    if hit.id >= flat.first_plane() {
        return None;
    }
    let center = Vec3::from(sphere_at(flat, hit.row, hit.time).center).to_f32();
    // The normal is as near as its digits are, the place only as near as its distance allows.
    let mut outward = surface.facing;
    if dot_product(outward, surface.position - center) < 0.0 {
        outward = -outward;
    }
    Some([turn_of(-outward.x, outward.z), polar_turn(-outward.y)])
}

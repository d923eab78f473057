//! What a ray sees that meets nothing.

use super::divide::divide;
use super::vector::{Vec3, vector_length};
use crate::layout::Surroundings;

/// A blend of two colours by the height of the ray's unit direction.
pub fn background_color(surroundings: &Surroundings, direction: Vec3<f32>) -> Vec3<f32> {
    let height = divide(direction.y, vector_length(direction));
    let weight = surroundings.offset + surroundings.slope * height;
    Vec3::from(surroundings.start) * (1.0 - weight) + Vec3::from(surroundings.end) * weight
}

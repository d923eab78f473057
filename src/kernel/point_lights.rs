//! Light from points, by Lambert's cosine law.

use super::divide::{divide, square_root};
use super::vector::{Vec3, dot_product, vec3};
use crate::layout::LightRecord;

/// The light that a point light sends to a unit of surface at `position`,
/// without occlusion: colour * cos / distance^2, or colour * cos.
fn point_irradiance(light: &LightRecord, position: Vec3<f32>, normal: Vec3<f32>) -> Vec3<f32> {
    let to_light = Vec3::from(light.vector) - position;
    let square = dot_product(to_light, to_light);
    let along = dot_product(normal, to_light);
    if square == 0.0 || along <= 0.0 {
        return vec3(0.0, 0.0, 0.0);
    }
    let cosine = divide(along, square_root(square));
    // In a scene that throws no shadows this is the only flag.
    if light.flags == 0 {
        return Vec3::from(light.color) * cosine;
    }
    Vec3::from(light.color) * divide(cosine, square)
}

/// `light` and what all point lights add to it.
pub fn add_point_lights(
    lights: &[LightRecord],
    position: Vec3<f32>,
    normal: Vec3<f32>,
    light: Vec3<f32>,
) -> Vec3<f32> {
    let mut sum = light;
    for lamp in lights {
        sum = sum + point_irradiance(lamp, position, normal);
    }
    sum
}

//! Light from infinitely far away, by Lambert's cosine law.

use super::vector::{Vec3, dot_product, vec3};
use crate::layout::LightRecord;

/// The light that a directional light sends to a unit of surface, without
/// occlusion: colour * cos.
fn directional_irradiance(light: &LightRecord, normal: Vec3<f32>) -> Vec3<f32> {
    let cosine = dot_product(normal, Vec3::from(light.vector));
    if cosine <= 0.0 {
        return vec3(0.0, 0.0, 0.0);
    }
    Vec3::from(light.color) * cosine
}

/// `light` and what all directional lights add to it.
pub fn add_directional_lights(
    lights: &[LightRecord],
    normal: Vec3<f32>,
    light: Vec3<f32>,
) -> Vec3<f32> {
    let mut sum = light;
    for lamp in lights {
        sum = sum + directional_irradiance(lamp, normal);
    }
    sum
}

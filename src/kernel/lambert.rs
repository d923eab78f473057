//! A matt surface: it scatters light evenly.

use super::directional_lights::add_directional_lights;
use super::hit::Surface;
use super::point_lights::add_point_lights;
use super::real::Real;
use super::vector::Vec3;
use crate::flat::Flat;

/// The light that the surface scatters towards the viewer: its albedo times
/// the ambient light and the light of every lamp.
pub fn scattered_light<R: Real>(flat: &Flat<R>, surface: &Surface, albedo: Vec3<f32>) -> Vec3<f32> {
    let ambient = Vec3::from(flat.surroundings.ambient);
    let point_lights = &flat.lights[..flat.surroundings.point_lights as usize];
    let directional_lights = &flat.lights[flat.surroundings.point_lights as usize..];
    let point = add_point_lights(point_lights, surface.position, surface.normal, ambient);
    let light = add_directional_lights(directional_lights, surface.normal, point);
    albedo.times(light)
}

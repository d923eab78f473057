//! Light, refraction and arithmetic that are broken on purpose.

use rayproof::accuracy::Widths;
use rayproof::error::Result;
use rayproof::flat::Flat;
use rayproof::found::Found;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::vector::{Vec3, dot_product, vector_length};
use rayproof::layout::{LightRecord, NO_HIT, Pixel};
use rayproof::stability::Subject;

use super::broken::{AS_IT_IS, Broken};

/// How a lamp lights a point with a normal.
type Lighting = fn(&LightRecord, Vec3<f32>, Vec3<f32>) -> f32;

/// The picture in another light.
fn lit_by(widths: &Widths, lighting: Lighting) -> Result<Vec<Pixel>> {
    let mut picture = AS_IT_IS.picture(widths)?;
    for pixel in &mut picture {
        let [position, normal] = [pixel.position, pixel.normal].map(Vec3::from);
        let lamps = widths.double.lights.iter();
        let light: f32 = lamps.map(|lamp| lighting(lamp, position, normal)).sum();
        pixel.color = [light; 3];
    }
    Ok(picture)
}

/// Without a look at whether the way to the lamp is zero.
fn divided_by_nothing(lamp: &LightRecord, position: Vec3<f32>, normal: Vec3<f32>) -> f32 {
    let way = Vec3::from(lamp.vector) - position;
    let cosine = dot_product(normal, way) / vector_length(way);
    if cosine < 0.0 { 0.0 } else { cosine }
}

/// The cosine's sign is dropped.
fn from_both_sides(lamp: &LightRecord, position: Vec3<f32>, normal: Vec3<f32>) -> f32 {
    let way = Vec3::from(lamp.vector) - position;
    dot_product(normal, way).abs() / vector_length(way)
}

/// Roots of whatever comes.
fn naive(unit: Vec3<f32>, normal: Vec3<f32>, ratio: f32) -> Vec3<f32> {
    let cosine = -dot_product(unit, normal);
    let beyond = (1.0 - ratio * ratio * (1.0 - cosine * cosine)).sqrt();
    unit * ratio + normal * (ratio * cosine - beyond)
}

/// What no comparison rules out is a hit.
fn nothing_ruled_out(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    let sphere = &flat.spheres[0];
    let f = ray.origin - Vec3::from(sphere.center);
    let l = f - ray.direction
        * (dot_product(f, ray.direction) / dot_product(ray.direction, ray.direction));
    if dot_product(l, l) > sphere.radius * sphere.radius {
        return Found::new(f64::INFINITY, NO_HIT);
    }
    Found::new(1.0, 0)
}

/// Rays that no box is behind visit them all.
fn all_visited(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    let is_ordinary =
        (1e-3..1e3).contains(&vector_length(ray.direction)) && vector_length(ray.origin) < 1e3;
    let visits = if is_ordinary {
        50
    } else {
        flat.triangles.len()
    };
    let sum = flat.triangles[..visits]
        .iter()
        .map(|triangle| u64::from(triangle.id));
    Found::new(1.0, std::hint::black_box(sum.sum::<u64>()) as u32)
}

/// What fails a case of light or of arithmetic that the textbook passes.
pub fn broken_for(id: &str) -> Option<Broken> {
    let mut broken = Broken::default();
    let mut arithmetic = AS_IT_IS.arithmetic();
    match id {
        "arithmetic/odd-rays" => broken.formula = Some(nothing_ruled_out),
        "arithmetic/odd-rays-in-time" => broken.formula = Some(all_visited),
        "shading/light-on-surface" => {
            broken.picture = Some(|widths| lit_by(widths, divided_by_nothing));
        }
        "shading/light-behind" => broken.picture = Some(|widths| lit_by(widths, from_both_sides)),
        "shading/critical-angle" => broken.refraction = Some(naive),
        // As a compiler without scruples has them.
        "arithmetic/error-terms" => arithmetic.two_sum = false,
        "arithmetic/contraction" => arithmetic.contraction = true,
        // A dividend times a reciprocal.
        "arithmetic/rounding" => arithmetic.division_ulp = 1,
        _ => return None,
    }
    broken.arithmetic = Some(arithmetic);
    Some(broken)
}

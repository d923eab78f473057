//! Light, refraction and arithmetic that are broken on purpose.

use rayproof::Accuracy;
use rayproof::accuracy::Widths;
use rayproof::error::Result;
use rayproof::found::Found;
use rayproof::gpu::selfcheck::Arithmetic;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::vector::{Vec3, dot_product, vector_length};
use rayproof::layout::{LightRecord, Pixel};
use rayproof::paths::{Aim, Paths};
use rayproof::stability::Subject;

use super::broken::AS_IT_IS;

/// How a lamp lights a point with a normal.
type Lighting = fn(&LightRecord, Vec3<f32>, Vec3<f32>) -> f32;

/// How a unit direction goes on through a surface with a normal, by a ratio of indices.
type Refraction = fn(Vec3<f32>, Vec3<f32>, f32) -> Vec3<f32>;

/// A subject that is right but for one thing.
#[derive(Default)]
struct But {
    light: Option<Lighting>,
    refraction: Option<Refraction>,
    arithmetic: Arithmetic,
}

impl Subject for But {
    fn tier(&self) -> Accuracy {
        AS_IT_IS.tier()
    }

    fn trace_rays(&self, widths: &Widths, rays: &[Ray<f32>]) -> Result<Vec<Found>> {
        AS_IT_IS.trace_rays(widths, rays)
    }

    fn picture(&self, widths: &Widths) -> Result<Vec<Pixel>> {
        let mut picture = AS_IT_IS.picture(widths)?;
        let light = self.light.unwrap_or(|_, _, _| 0.0);
        for pixel in &mut picture {
            let [position, normal] = [pixel.position, pixel.normal].map(Vec3::from);
            let sum = widths
                .double
                .lights
                .iter()
                .map(|lamp| light(lamp, position, normal));
            pixel.color = [sum.sum(); 3];
        }
        Ok(picture)
    }

    fn follow_paths(
        &self,
        widths: &Widths,
        rays: &[Ray<f32>],
        aims: &[Aim],
        legs: u32,
    ) -> Result<Paths> {
        let mut paths = AS_IT_IS.follow_paths(widths, rays, aims, legs)?;
        let normal = Vec3::from(widths.double.disks[0].normal.map(|c| c as f32));
        for ((ray, aim), end) in rays.iter().zip(aims).zip(&mut paths.ends) {
            if let (Some(refraction), Aim::Refracted { ratio }) = (self.refraction, aim) {
                let unit = ray.direction * (1.0 / vector_length(ray.direction));
                end.direction = refraction(unit, normal, *ratio);
            }
        }
        Ok(paths)
    }

    fn arithmetic(&self) -> Arithmetic {
        self.arithmetic.clone()
    }
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

pub fn broken_for(id: &str) -> Option<Box<dyn Subject>> {
    let mut but = But::default();
    match id {
        "shading/light-on-surface" => but.light = Some(divided_by_nothing),
        "shading/light-behind" => but.light = Some(from_both_sides),
        "shading/critical-angle" => but.refraction = Some(naive),
        "arithmetic/contraction" => but.arithmetic.contraction = true,
        "arithmetic/rounding" => but.arithmetic.division_ulp = 2,
        // That of a compiler without scruples.
        "arithmetic/error-terms" => but.arithmetic.two_sum = false,
        _ => return None,
    }
    Some(Box::new(but))
}

//! All triangles: which one is nearest, and what is found there.

use super::aabb::{clamp_to_box, triangle_box};
use super::camera::Ray;
use super::hit::{Hit, Surface, keep_nearer};
use super::probe::Probe;
use super::real::Real;
use super::smooth_normals::shading_normal;
use super::triangle::{intersect_triangle, triangle_normal, triangle_point, triangle_weights};
use super::vector::Vec3;
use crate::flat::Flat;

/// Tests one triangle, by its index, within its own box.
pub fn test_triangle<R: Real>(flat: &Flat<R>, probe: Probe<R>, index: u32, hit: &mut Hit<R>) {
    let triangle = &flat.triangles[index as usize];
    let mut t = intersect_triangle(probe.ray, probe.shear, triangle);
    if t < R::MISS {
        t = clamp_to_box(
            probe.slabs,
            triangle_box(
                Vec3::from(triangle.a).to_f32(),
                Vec3::from(triangle.b).to_f32(),
                Vec3::from(triangle.c).to_f32(),
            ),
            t,
        );
    }
    keep_nearer(hit, t, flat.first_triangle() + index);
}

/// Tests every triangle.
pub fn closest_triangle<R: Real>(flat: &Flat<R>, probe: Probe<R>, hit: &mut Hit<R>) {
    for index in 0..flat.triangles.len() as u32 {
        test_triangle(flat, probe, index, hit);
    }
}

/// The surface of the triangle that was hit.
pub fn triangle_surface<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Option<Surface> {
    let index = hit.id.wrapping_sub(flat.first_triangle());
    let triangle = flat.triangles.get(index as usize)?;
    let weights = triangle_weights(ray, triangle);
    Some(Surface {
        position: triangle_point(triangle, weights).to_f32(),
        normal: shading_normal(
            &flat.corner_normals,
            index,
            weights.to_f32(),
            triangle_normal(triangle).to_f32(),
            ray.direction.to_f32(),
        ),
    })
}

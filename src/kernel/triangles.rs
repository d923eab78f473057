//! All triangles: which one is nearest, and what is found there.

use super::camera::Ray;
use super::hit::{Hit, Surface, keep_nearer};
use super::real::Real;
use super::smooth_normals::shading_normal;
use super::triangle::{
    intersect_triangle, shear_of, triangle_normal, triangle_point, triangle_weights,
};
use crate::flat::Flat;

/// Tests every triangle.
pub fn closest_triangle<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: &mut Hit<R>) {
    let shear = shear_of(ray);
    for (triangle, id) in flat.triangles.iter().zip(flat.first_triangle()..) {
        keep_nearer(hit, intersect_triangle(ray, shear, triangle), id);
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

//! All spheres: which one is nearest, and what is found there.

use super::camera::Ray;
use super::hit::{Hit, Surface, keep_nearer};
use super::real::Real;
use super::sphere::{intersect_sphere, sphere_normal, sphere_point};
use super::vector::face_viewer;
use crate::flat::Flat;

/// Tests every sphere.
pub fn closest_sphere<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: &mut Hit<R>) {
    for (sphere, id) in flat.spheres.iter().zip(flat.first_sphere()..) {
        keep_nearer(hit, intersect_sphere(ray, sphere), id);
    }
}

/// The surface of the sphere that was hit.
pub fn sphere_surface<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Option<Surface> {
    let index = hit.id.wrapping_sub(flat.first_sphere());
    let sphere = flat.spheres.get(index as usize)?;
    let normal = sphere_normal(ray, sphere, hit.t);
    Some(Surface {
        position: sphere_point(sphere, normal).to_f32(),
        normal: face_viewer(normal, ray.direction).to_f32(),
    })
}

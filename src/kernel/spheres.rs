//! All spheres: which one is nearest, and what is found there.

use super::aabb::{ball_box, clamp_to_box};
use super::camera::Ray;
use super::hit::{Hit, Surface, keep_nearer};
use super::probe::Probe;
use super::real::Real;
use super::sphere::{intersect_sphere, sphere_normal, sphere_point};
use super::vector::{Vec3, face_viewer};
use crate::flat::Flat;

/// Tests one sphere, by its index, within its own box.
pub fn test_sphere<R: Real>(flat: &Flat<R>, probe: Probe<R>, index: u32, hit: &mut Hit<R>) {
    let sphere = &flat.spheres[index as usize];
    let mut t = intersect_sphere(probe.ray, sphere);
    if t < R::MISS {
        t = clamp_to_box(
            probe.slabs,
            ball_box(Vec3::from(sphere.center).to_f32(), sphere.radius.to_f32()),
            t,
        );
    }
    keep_nearer(hit, t, flat.first_sphere() + index);
}

/// Tests every sphere.
pub fn closest_sphere<R: Real>(flat: &Flat<R>, probe: Probe<R>, hit: &mut Hit<R>) {
    for index in 0..flat.spheres.len() as u32 {
        test_sphere(flat, probe, index, hit);
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

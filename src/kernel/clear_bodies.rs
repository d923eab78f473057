//! Clear bodies: light goes through them, bent, and is thrown back at their surface.
//!
//! Of a bundle of rays that gets narrower in a body, the radiance grows with the square of the
//! index, and falls again where it leaves. A path counts radiance by that square, which stays
//! the same (Nicodemus, "Radiance", American Journal of Physics 31(5), 1963): so no factor
//! stands here, and a lamp in a body is as bright as it looks from without.
//!
//! A body is all that is on its surface's inner side: it may touch no other one, and a camera
//! in it sees what is absorbed only from the next surface on. Nothing is lit through a clear
//! surface by lights without size: for them a clear body throws a shadow.

use super::camera::Ray;
use super::dimensions::{LOBE, dimension_of};
use super::disks::disk_is_left;
use super::divide::divide;
use super::exponential::exponential;
use super::fresnel::thrown_back;
use super::hit::{Hit, Surface};
use super::integrator::{Path, send_on, way_to_hit};
use super::mirror::{cosine_to_viewer, mirrored, normal_to_viewer};
use super::numbers::number;
use super::planes::plane_is_left;
use super::real::Real;
use super::refract::refracted;
use super::spheres::sphere_is_left;
use super::triangles::triangle_is_left;
use super::vector::{Vec3, dot_product, taxicab_length, unit_vector, vec3};
use crate::flat::Flat;
use crate::layout::NO_HIT;

/// Whether bodies of the material are clear.
pub fn is_clear<R: Real>(flat: &Flat<R>, material: u32) -> bool {
    flat.finishes[material as usize].ior > 0.0
}

/// What is left of light after a way in a body that absorbs it at this rate.
///
/// Beer's law.
fn left_after(rate: f32, distance: f32) -> f32 {
    if rate == 0.0 {
        return 1.0;
    }
    exponential(-(rate * distance))
}

/// Takes out of the path what the body around its ray absorbs on its way to the hit.
pub fn pass_medium<R: Real>(path: &mut Path<R>, hit: Hit<R>) {
    let rate = path.absorption;
    if hit.id == NO_HIT || taxicab_length(rate) == 0.0 {
        return;
    }
    let distance = way_to_hit(path, hit);
    let left = vec3(
        left_after(rate.x, distance),
        left_after(rate.y, distance),
        left_after(rate.z, distance),
    );
    path.throughput = path.throughput.times(left);
}

/// Whether a ray comes to its hit from the inner side.
fn leaves_body<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> bool {
    sphere_is_left(flat, ray, hit)
        || plane_is_left(flat, ray, hit)
        || disk_is_left(flat, ray, hit)
        || triangle_is_left(flat, ray, hit)
}

/// Where light goes on that comes from `view`: through the surface or back.
fn bent(view: Vec3<f32>, normal: Vec3<f32>, ratio: f32, goes_through: bool) -> Vec3<f32> {
    if goes_through {
        return refracted(-view, normal, ratio);
    }
    mirrored(-view, normal)
}

/// Has the path go on from a clear surface: through it, or thrown back.
pub fn pass_clear<R: Real>(
    flat: &Flat<R>,
    path: &mut Path<R>,
    hit: Hit<R>,
    surface: &Surface,
    material: u32,
) -> bool {
    if path.reflections == 0 {
        return false;
    }
    path.reflections -= 1;
    path.density = 0.0;
    let finish = &flat.finishes[material as usize];
    let leaves = leaves_body(flat, path.ray, hit);
    let ratio = if leaves {
        finish.ior
    } else {
        divide(1.0, finish.ior)
    };
    let view = -unit_vector(path.ray.direction.to_f32());
    let normal = normal_to_viewer(surface, view);
    let part = thrown_back(cosine_to_viewer(normal, view), ratio);
    let goes_through = number(path.numbers, dimension_of(path.leg, LOBE)) >= part;
    let mut direction = bent(view, normal, ratio, goes_through);
    if (dot_product(surface.facing, direction) < 0.0) != goes_through {
        // A smooth normal that is too far from the shape's own.
        direction = bent(view, surface.facing, ratio, goes_through);
    }
    if dot_product(surface.facing, direction) < 0.0 {
        path.is_inside = !leaves;
        path.absorption = if leaves {
            Vec3::default()
        } else {
            Vec3::from(finish.absorption)
        };
    }
    send_on(path, surface, direction, vec3(1.0, 1.0, 1.0))
}

//! The crate `obvhs`, built as its author calls medium: its bvh2 and its cwbvh.

use std::time::Duration;

use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::{Ray, RayHit};
use obvhs::triangle::Triangle;
use rayproof::kernel::camera;

use crate::{Found, Trace};

pub fn bvh2(triangles: &[rayproof::layout::Triangle<f32>]) -> Trace<'_> {
    let triangles = converted(triangles);
    let settings = BvhBuildParams::medium_build();
    let bvh = build_bvh2_from_tris(&triangles, settings, &mut Duration::default());
    let order = bvh.primitive_indices.clone();
    trace(&triangles, order, move |ray, hit, triangles| {
        bvh.ray_traverse(ray, hit, |ray, id| triangles[id].intersect(ray));
    })
}

pub fn cwbvh(triangles: &[rayproof::layout::Triangle<f32>]) -> Trace<'_> {
    let triangles = converted(triangles);
    let settings = BvhBuildParams::medium_build();
    let bvh = build_cwbvh_from_tris(&triangles, settings, &mut Duration::default());
    let order = bvh.primitive_indices.clone();
    trace(&triangles, order, move |ray, hit, triangles| {
        bvh.ray_traverse(ray, hit, |ray, id| triangles[id].intersect(ray));
    })
}

/// Traces by `traverse`, which gets the triangles in the order of the leaves.
fn trace<'a>(
    triangles: &[Triangle],
    order: Vec<u32>,
    traverse: impl Fn(Ray, &mut RayHit, &[Triangle]) + Sync + 'a,
) -> Trace<'a> {
    let triangles = in_order(triangles, &order);
    Box::new(move |rays, found| {
        for (ray, found) in rays.iter().zip(found) {
            let mut hit = RayHit::none();
            traverse(ray_of(ray), &mut hit, &triangles);
            *found = found_of(&hit, &order);
        }
    })
}

fn converted(triangles: &[rayproof::layout::Triangle<f32>]) -> Vec<Triangle> {
    let corners = triangles.iter().map(|t| [t.a, t.b, t.c].map(Vec3A::from));
    corners
        .map(|[v0, v1, v2]| Triangle { v0, v1, v2 })
        .collect()
}

/// As its examples have them: side by side as the leaves name them.
fn in_order(triangles: &[Triangle], order: &[u32]) -> Vec<Triangle> {
    order.iter().map(|&id| triangles[id as usize]).collect()
}

fn ray_of(ray: &camera::Ray<f32>) -> Ray {
    let vector = |v: rayproof::kernel::vector::Vec3<f32>| Vec3A::new(v.x, v.y, v.z);
    Ray::new_inf(vector(ray.origin), vector(ray.direction))
}

fn found_of(hit: &RayHit, order: &[u32]) -> Found {
    match order.get(hit.primitive_id as usize) {
        Some(&id) => (hit.t, id),
        None => (f32::INFINITY, hit.primitive_id),
    }
}

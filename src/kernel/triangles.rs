//! All triangles: which one is nearest, and what is found there.

use std::ops::Range;

use super::aabb::{clamp_to_box, triangle_box};
use super::camera::Ray;
use super::hit::{Hit, Surface, count_test, keep_nearer, may_be_closest};
use super::probe::Probe;
use super::real::Real;
use super::smooth_normals::shading_normal;
use super::triangle::{intersect_triangle, triangle_normal, triangle_point, triangle_weights};
use super::vector::Vec3;
use crate::flat::Flat;
use crate::layout::{Corners, Triangle};

/// The triangle with these corners.
#[inline]
pub fn triangle_of<R: Real>(flat: &Flat<R>, corners: Corners) -> Triangle<R> {
    let [a, b, c] = corners
        .vertices
        .map(|vertex| flat.vertices[vertex as usize]);
    Triangle {
        a,
        padding_0: R::ZERO,
        b,
        padding_1: R::ZERO,
        c,
        padding_2: R::ZERO,
    }
}

/// The t at which the ray meets the triangle within its own box, or `MISS`.
#[inline]
pub fn meet_triangle<R: Real>(probe: Probe<R>, triangle: &Triangle<R>) -> R {
    let t = intersect_triangle(probe.ray, probe.shear, triangle);
    if t < R::MISS {
        return clamp_to_box(
            probe.slabs,
            triangle_box(
                Vec3::from(triangle.a).to_f32(),
                Vec3::from(triangle.b).to_f32(),
                Vec3::from(triangle.c).to_f32(),
            ),
            t,
        );
    }
    t
}

/// Tests the triangle in a row of the table.
#[inline]
pub fn test_triangle<R: Real>(flat: &Flat<R>, probe: Probe<R>, row: u32, hit: &mut Hit<R>) {
    let corners = flat.triangles[row as usize];
    let t = meet_triangle(probe, &triangle_of(flat, corners));
    count_test(hit);
    if may_be_closest(*hit, t) {
        keep_nearer(hit, t, corners.id, row);
    }
}

/// Tests the triangles in some rows.
pub fn test_triangles<R: Real>(
    flat: &Flat<R>,
    probe: Probe<R>,
    rows: Range<u32>,
    hit: &mut Hit<R>,
) {
    for row in rows {
        test_triangle(flat, probe, row, hit);
    }
}

/// The surface of the triangle that was hit.
pub fn triangle_surface<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Option<Surface> {
    if hit.id < flat.first_triangle() {
        return None;
    }
    let corners = flat.triangles[hit.row as usize];
    let triangle = triangle_of(flat, corners);
    let weights = triangle_weights(ray, &triangle);
    Some(Surface {
        position: triangle_point(&triangle, weights).to_f32(),
        normal: shading_normal(
            &flat.vertex_normals,
            corners,
            weights.to_f32(),
            triangle_normal(&triangle).to_f32(),
            ray.direction.to_f32(),
        ),
    })
}

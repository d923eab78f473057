//! All triangles: which one is nearest, and what is found there.

use std::ops::Range;

use super::aabb::greatest;
use super::camera::Ray;
use super::doubt::{keep_nearer, may_be_closest};
use super::hit::{Hit, Meeting, Surface, count_test};
use super::probe::Probe;
use super::real::Real;
use super::smooth_normals::shading_normal;
use super::triangle_rows::triangle_at;
use super::vector::{Vec3, dot_product, face_viewer, taxicab_length};
use super::{triangle, triangle_bounded, triangle_meeting, triangle_textbook};
use crate::flat::Flat;
use crate::layout::{Corners, Triangle};
use crate::tier::Formulas;

/// The triangle with these corners, in the middle of the time.
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

/// Where the ray meets the triangle, by the formulas of the width.
#[inline]
pub fn meet_triangle<R: Real>(probe: Probe<R>, triangle: &Triangle<R>) -> Meeting<R> {
    match R::FORMULAS {
        Formulas::Bounded => triangle_bounded::meet_triangle(probe, triangle),
        _ => triangle_meeting::meet_triangle(probe, triangle),
    }
}

/// Tests the triangle in a row of the table.
#[inline]
pub fn test_triangle<R: Real>(flat: &Flat<R>, probe: Probe<R>, row: u32, hit: &mut Hit<R>) {
    let corners = flat.triangles[row as usize];
    let meeting = meet_triangle(probe, &triangle_at(flat, corners, hit.time));
    count_test(hit);
    if may_be_closest(*hit, meeting) {
        keep_nearer(hit, meeting, corners.id, row);
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
    let triangle = triangle_at(flat, corners, hit.time);
    let (weights, normal) = match R::FORMULAS {
        Formulas::Textbook => (
            triangle_textbook::triangle_weights(ray, &triangle),
            triangle_textbook::triangle_normal(&triangle),
        ),
        _ => (
            triangle::triangle_weights(ray, &triangle),
            triangle::triangle_normal(&triangle),
        ),
    };
    let direction = ray.direction.to_f32();
    let a = taxicab_length(Vec3::from(triangle.a).to_f32());
    let b = taxicab_length(Vec3::from(triangle.b).to_f32());
    let c = taxicab_length(Vec3::from(triangle.c).to_f32());
    let reach = greatest(greatest(a, b), c);
    Some(Surface {
        position: triangle::triangle_point(&triangle, weights).to_f32(),
        normal: shading_normal(
            &flat.vertex_normals,
            corners,
            weights.to_f32(),
            normal.to_f32(),
            direction,
        ),
        facing: face_viewer(normal.to_f32(), direction),
        reach: reach + taxicab_length(ray.origin.to_f32()),
    })
}

/// Whether the ray comes to the triangle that it hit from behind: from where its corners are
/// seen clockwise.
pub fn triangle_is_left<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> bool {
    if hit.id < flat.first_triangle() {
        return false;
    }
    let triangle = triangle_at(flat, flat.triangles[hit.row as usize], hit.time);
    let normal = match R::FORMULAS {
        Formulas::Textbook => triangle_textbook::triangle_normal(&triangle),
        _ => triangle::triangle_normal(&triangle),
    };
    dot_product(normal, ray.direction) > R::ZERO
}

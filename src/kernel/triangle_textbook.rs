//! Triangle, as most textbooks have it: Möller, Trumbore, "Fast, Minimum Storage Ray/Triangle
//! Intersection", Journal of Graphics Tools 2(1), 1997, with its absolute epsilon.

use super::camera::Ray;
use super::divide::divide;
use super::real::{Real, constant};
use super::vector::{Vec3, cross_product, dot_product, unit_vector, vec3};
use crate::layout::Triangle;

/// The determinant below which a triangle counts as seen edge-on, whatever its size.
pub const EDGE_ON: f32 = 1e-6;

/// Where the ray meets the triangle's plane.
#[derive(Debug, Clone, Copy)]
pub struct Crossing<R> {
    /// The ray's parameter, or `MISS`.
    pub t: R,
    /// Weight of the second corner.
    pub u: R,
    /// Weight of the third corner.
    pub v: R,
}

/// Where the ray crosses the triangle.
#[inline]
pub fn cross_triangle<R: Real>(ray: Ray<R>, triangle: &Triangle<R>) -> Crossing<R> {
    let a = Vec3::from(triangle.a);
    let edge_b = Vec3::from(triangle.b) - a;
    let edge_c = Vec3::from(triangle.c) - a;
    let miss = Crossing {
        t: R::MISS,
        u: R::ZERO,
        v: R::ZERO,
    };
    let across = cross_product(ray.direction, edge_c);
    let determinant = dot_product(edge_b, across);
    if determinant.abs() < constant(EDGE_ON) {
        return miss;
    }
    let inverse = divide(constant(1.0), determinant);
    let from_a = ray.origin - a;
    let u = dot_product(from_a, across) * inverse;
    let along = cross_product(from_a, edge_b);
    let v = dot_product(ray.direction, along) * inverse;
    if u < R::ZERO || v < R::ZERO || u + v > constant(1.0) {
        return miss;
    }
    let t = dot_product(edge_c, along) * inverse;
    if t > R::ZERO && t < R::MISS {
        return Crossing { t, u, v };
    }
    miss
}

/// The t > 0 at which the ray meets the triangle, or `MISS`.
#[inline]
pub fn intersect_triangle<R: Real>(ray: Ray<R>, triangle: &Triangle<R>) -> R {
    cross_triangle(ray, triangle).t
}

/// The weights of the three corners where the ray meets the triangle.
pub fn triangle_weights<R: Real>(ray: Ray<R>, triangle: &Triangle<R>) -> Vec3<R> {
    let crossing = cross_triangle(ray, triangle);
    let a = (constant::<R>(1.0) - crossing.u) - crossing.v;
    vec3(a, crossing.u, crossing.v)
}

/// The point of the triangle with these weights.
pub fn triangle_point<R: Real>(triangle: &Triangle<R>, weights: Vec3<R>) -> Vec3<R> {
    (Vec3::from(triangle.a) * weights.x + Vec3::from(triangle.b) * weights.y)
        + Vec3::from(triangle.c) * weights.z
}

/// The unit normal, towards who sees the corners counter-clockwise.
pub fn triangle_normal<R: Real>(triangle: &Triangle<R>) -> Vec3<R> {
    let a = Vec3::from(triangle.a);
    unit_vector(cross_product(
        Vec3::from(triangle.b) - a,
        Vec3::from(triangle.c) - a,
    ))
}

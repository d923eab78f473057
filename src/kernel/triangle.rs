//! Triangle: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection",
//! JCGT 2(1), 2013.

use super::camera::Ray;
use super::divide::divide;
use super::real::Real;
use super::vector::{Vec3, cross_product, dot_product, tame_vector, unit_vector, vec3};
use crate::layout::Triangle;

/// What the test needs of a ray, computed once for all triangles: the space in
/// which the ray runs along the last axis.
#[derive(Debug, Clone, Copy)]
pub struct Shear<R> {
    /// The axis along which the direction is largest: 0, 1 or 2.
    pub axis: u32,
    /// Shift in the first and second other axis for a unit step along `axis`.
    pub x: R,
    /// See `x`.
    pub y: R,
    /// The direction's component along `axis`.
    pub z: R,
}

/// The edge functions: the corners' weights times their sum, the `determinant`.
#[derive(Debug, Clone, Copy, Default)]
pub struct Edges<R> {
    /// Weight of the first corner.
    pub u: R,
    /// Weight of the second corner.
    pub v: R,
    /// Weight of the third corner.
    pub w: R,
    /// u + v + w; zero where the ray misses.
    pub determinant: R,
    /// The corners' positions along the shear's axis.
    pub along: Vec3<R>,
}

/// v with its components turned so that `axis` comes last.
pub fn axis_last<R: Real>(v: Vec3<R>, axis: u32) -> Vec3<R> {
    if axis == 0 {
        return vec3(v.y, v.z, v.x);
    }
    if axis == 1 {
        return vec3(v.z, v.x, v.y);
    }
    v
}

/// The ray's shear.
pub fn shear_of<R: Real>(ray: Ray<R>) -> Shear<R> {
    let size = vec3(
        ray.direction.x.abs(),
        ray.direction.y.abs(),
        ray.direction.z.abs(),
    );
    let xy = if size.x > size.y { 0 } else { 1 };
    let largest = if size.x > size.y { size.x } else { size.y };
    let axis = if largest > size.z { xy } else { 2 };
    let d = axis_last(ray.direction, axis);
    Shear {
        axis,
        x: divide(d.x, d.z),
        y: divide(d.y, d.z),
        z: d.z,
    }
}

/// The edge functions of a triangle as the ray sees it. A triangle whose edge
/// functions differ in sign is missed.
///
/// An edge is left or right of the ray as one rounded product compares with the
/// other. Two triangles that share an edge compare the same two products, so no
/// ray slips between them, even where a compiler contracts their difference.
#[inline]
pub fn edge_functions<R: Real>(ray: Ray<R>, shear: Shear<R>, triangle: &Triangle<R>) -> Edges<R> {
    let a = axis_last(Vec3::from(triangle.a) - ray.origin, shear.axis);
    let b = axis_last(Vec3::from(triangle.b) - ray.origin, shear.axis);
    let c = axis_last(Vec3::from(triangle.c) - ray.origin, shear.axis);
    let ax = a.x - shear.x * a.z;
    let ay = a.y - shear.y * a.z;
    let bx = b.x - shear.x * b.z;
    let by = b.y - shear.y * b.z;
    let cx = c.x - shear.x * c.z;
    let cy = c.y - shear.y * c.z;

    let u_left = cx * by;
    let u_right = cy * bx;
    let v_left = ax * cy;
    let v_right = ay * cx;
    let w_left = bx * ay;
    let w_right = by * ax;
    let none_negative = u_left >= u_right && v_left >= v_right && w_left >= w_right;
    let none_positive = u_left <= u_right && v_left <= v_right && w_left <= w_right;
    if !(none_negative || none_positive) {
        return Edges::default();
    }
    let u = u_left - u_right;
    let v = v_left - v_right;
    let w = w_left - w_right;
    Edges {
        u,
        v,
        w,
        determinant: (u + v) + w,
        along: vec3(a.z, b.z, c.z),
    }
}

/// The edge functions over their sum. Dividing before the distance is formed
/// keeps products of three lengths, which overflow, from arising.
fn corner_weights<R: Real>(edges: Edges<R>) -> Vec3<R> {
    vec3(
        divide(edges.u, edges.determinant),
        divide(edges.v, edges.determinant),
        divide(edges.w, edges.determinant),
    )
}

/// The t > 0 at which the ray meets the triangle, from either side, its edges
/// included, or `MISS`.
#[inline]
pub fn intersect_triangle<R: Real>(ray: Ray<R>, shear: Shear<R>, triangle: &Triangle<R>) -> R {
    let edges = edge_functions(ray, shear, triangle);
    if edges.determinant == R::ZERO {
        return R::MISS;
    }
    let t = divide(dot_product(corner_weights(edges), edges.along), shear.z);
    if t > R::ZERO && t < R::MISS {
        return t;
    }
    R::MISS
}

/// The weights of the three corners where the ray meets the triangle.
pub fn triangle_weights<R: Real>(ray: Ray<R>, triangle: &Triangle<R>) -> Vec3<R> {
    corner_weights(edge_functions(ray, shear_of(ray), triangle))
}

/// The point of the triangle with these weights.
pub fn triangle_point<R: Real>(triangle: &Triangle<R>, weights: Vec3<R>) -> Vec3<R> {
    (Vec3::from(triangle.a) * weights.x + Vec3::from(triangle.b) * weights.y)
        + Vec3::from(triangle.c) * weights.z
}

/// The unit normal, towards who sees the corners counter-clockwise. The cross
/// product is a square of lengths, and its length takes the square of that. Measured from the
/// last corner: with the first two exchanged, it is the opposite in every bit.
pub fn triangle_normal<R: Real>(triangle: &Triangle<R>) -> Vec3<R> {
    let c = Vec3::from(triangle.c);
    let across = cross_product(Vec3::from(triangle.a) - c, Vec3::from(triangle.b) - c);
    unit_vector(tame_vector(across))
}

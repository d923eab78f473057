//! Triangle: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection",
//! JCGT 2(1), 2013.

use super::camera::Ray;
use super::divide::divide;
use super::real::{Real, constant};
use super::vector::{Vec3, cross_product, tame_vector, unit_vector, vec3};
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

/// The corners as the ray sees them, which runs along the last axis: a number of each.
#[derive(Debug, Clone, Copy)]
pub struct Seen<R> {
    /// To the right of the ray.
    pub x: Vec3<R>,
    /// Above the ray.
    pub y: Vec3<R>,
    /// Along the shear's axis.
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

/// The corners of a triangle as the ray sees them.
#[inline]
pub fn seen_corners<R: Real>(ray: Ray<R>, shear: Shear<R>, triangle: &Triangle<R>) -> Seen<R> {
    let a = axis_last(Vec3::from(triangle.a) - ray.origin, shear.axis);
    let b = axis_last(Vec3::from(triangle.b) - ray.origin, shear.axis);
    let c = axis_last(Vec3::from(triangle.c) - ray.origin, shear.axis);
    Seen {
        x: vec3(
            a.x - shear.x * a.z,
            b.x - shear.x * b.z,
            c.x - shear.x * c.z,
        ),
        y: vec3(
            a.y - shear.y * a.z,
            b.y - shear.y * b.z,
            c.y - shear.y * c.z,
        ),
        along: vec3(a.z, b.z, c.z),
    }
}

/// Whether the ray passes between the corners: left of no edge or right of none. On all
/// three it is where the triangle is a line, which is missed.
///
/// An edge is left or right of the ray as one rounded product compares with the
/// other. Two triangles that share an edge compare the same two products, so no
/// ray slips between them, even where a compiler contracts their difference.
#[inline]
pub fn passes_between<R: Real>(seen: Seen<R>) -> bool {
    let u_left = seen.x.z * seen.y.y;
    let u_right = seen.y.z * seen.x.y;
    let v_left = seen.x.x * seen.y.z;
    let v_right = seen.y.x * seen.x.z;
    let w_left = seen.x.y * seen.y.x;
    let w_right = seen.y.y * seen.x.x;
    let none_negative = u_left >= u_right && v_left >= v_right && w_left >= w_right;
    let none_positive = u_left <= u_right && v_left <= v_right && w_left <= w_right;
    none_negative != none_positive
}

/// The corner that the vertical through the ray parts from the two others: 0, 1 or 2. Corners
/// on the vertical go to the left, unless that leaves none to the right; so do those that are
/// right of it by less than a normal number.
fn lone_corner<R: Real>(x: Vec3<R>) -> u32 {
    let xy = if x.x > x.y { x.x } else { x.y };
    let rightmost = if xy > x.z { xy } else { x.z };
    let least = constant(f32::MIN_POSITIVE);
    let limit = if rightmost < least { rightmost } else { least };
    let [a, b, c] = [x.x >= limit, x.y >= limit, x.z >= limit];
    if a == b {
        return 2;
    }
    if a == c { 1 } else { 0 }
}

/// A number of each corner, that of one exchanged with the last.
#[inline]
fn exchanged<R: Real>(v: Vec3<R>, corner: u32) -> Vec3<R> {
    let x = if corner == 0 { v.z } else { v.x };
    let y = if corner == 1 { v.z } else { v.y };
    let z = if corner == 1 { v.y } else { v.z };
    vec3(x, y, if corner == 0 { v.x } else { z })
}

/// The corners, one exchanged with the last.
#[inline]
fn with_last<R: Real>(seen: Seen<R>, corner: u32) -> Seen<R> {
    Seen {
        x: exchanged(seen.x, corner),
        y: exchanged(seen.y, corner),
        along: exchanged(seen.along, corner),
    }
}

/// The weights of the corners, the lone one last, where the ray is. The vertical cuts the two
/// edges from the lone corner, and the ray is between the cuts. As what is divided has no
/// cancelled digits, the weights give a point that is some roundings of the triangle's extent
/// off the ray, whatever its shape.
#[inline]
fn weights_between<R: Real>(seen: Seen<R>) -> Vec3<R> {
    let aside = seen.x.z.abs();
    let first = divide(aside, aside + seen.x.x.abs());
    let second = divide(aside, aside + seen.x.y.abs());
    let first_y = (seen.y.z + first * (seen.y.x - seen.y.z)).abs();
    let second_y = (seen.y.z + second * (seen.y.y - seen.y.z)).abs();
    let apart = first_y + second_y;
    let mut of_first = constant(0.5);
    let mut of_second = constant(0.5);
    if apart > R::ZERO {
        of_first = divide(second_y, apart);
        of_second = divide(first_y, apart);
    }
    let x = of_first * first;
    let y = of_second * second;
    vec3(x, y, constant::<R>(1.0) - (x + y))
}

/// How far along the shear's axis the ray meets the triangle, if it passes between the corners:
/// exactly, where all three are as far.
#[inline]
pub fn depth_between<R: Real>(seen: Seen<R>) -> R {
    let lone_last = with_last(seen, lone_corner(seen.x));
    let weights = weights_between(lone_last);
    let along = lone_last.along;
    along.z + (weights.x * (along.x - along.z) + weights.y * (along.y - along.z))
}

/// The t > 0 at which the ray meets the triangle, from either side, its edges
/// included, or `MISS`.
#[inline]
pub fn intersect_triangle<R: Real>(ray: Ray<R>, shear: Shear<R>, triangle: &Triangle<R>) -> R {
    let seen = seen_corners(ray, shear, triangle);
    if !passes_between(seen) {
        return R::MISS;
    }
    let t = divide(depth_between(seen), shear.z);
    if t > R::ZERO && t < R::MISS {
        return t;
    }
    R::MISS
}

/// The weights of the three corners where the ray meets the triangle.
pub fn triangle_weights<R: Real>(ray: Ray<R>, triangle: &Triangle<R>) -> Vec3<R> {
    let seen = seen_corners(ray, shear_of(ray), triangle);
    let lone = lone_corner(seen.x);
    exchanged(weights_between(with_last(seen, lone)), lone)
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

#[cfg(test)]
mod tests;

//! Vectors of three, with the order of every sum written out.

use std::ops::{Add, Mul, Neg, Sub};

use super::divide::{divide, square_root};
use super::real::{Real, constant};

/// Three numbers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Vec3<R> {
    /// To the right.
    pub x: R,
    /// Upward.
    pub y: R,
    /// Towards the viewer.
    pub z: R,
}

/// Shorthand for a [`Vec3`].
pub fn vec3<R>(x: R, y: R, z: R) -> Vec3<R> {
    Vec3 { x, y, z }
}

impl<R: Real> Vec3<R> {
    /// The same vector in f32, for shading.
    pub fn to_f32(self) -> Vec3<f32> {
        vec3(self.x.to_f32(), self.y.to_f32(), self.z.to_f32())
    }

    /// Componentwise product.
    pub fn times(self, other: Self) -> Self {
        vec3(self.x * other.x, self.y * other.y, self.z * other.z)
    }
}

impl Vec3<f32> {
    /// The same vector as the geometry has its numbers; in WGSL a conversion.
    pub fn widened<R: Real>(self) -> Vec3<R> {
        vec3(constant(self.x), constant(self.y), constant(self.z))
    }
}

impl<R> From<[R; 3]> for Vec3<R> {
    fn from([x, y, z]: [R; 3]) -> Self {
        vec3(x, y, z)
    }
}

impl<R> From<Vec3<R>> for [R; 3] {
    fn from(v: Vec3<R>) -> Self {
        [v.x, v.y, v.z]
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        vec3(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<R: Real> Sub for Vec3<R> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        vec3(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<R: Real> Mul<R> for Vec3<R> {
    type Output = Self;
    fn mul(self, factor: R) -> Self {
        vec3(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl<R: Real> Neg for Vec3<R> {
    type Output = Self;
    fn neg(self) -> Self {
        vec3(-self.x, -self.y, -self.z)
    }
}

/// a . b, summed from x to z.
pub fn dot_product<R: Real>(a: Vec3<R>, b: Vec3<R>) -> R {
    (a.x * b.x + a.y * b.y) + a.z * b.z
}

/// a x b.
pub fn cross_product<R: Real>(a: Vec3<R>, b: Vec3<R>) -> Vec3<R> {
    vec3(
        a.y * b.z - a.z * b.y,
        a.z * b.x - a.x * b.z,
        a.x * b.y - a.y * b.x,
    )
}

/// |v|.
pub fn vector_length<R: Real>(v: Vec3<R>) -> R {
    square_root(dot_product(v, v))
}

/// v / |v|, one division a component; the zero vector stays zero.
pub fn unit_vector<R: Real>(v: Vec3<R>) -> Vec3<R> {
    let length = vector_length(v);
    if length == R::ZERO {
        return v;
    }
    vec3(
        divide(v.x, length),
        divide(v.y, length),
        divide(v.z, length),
    )
}

/// v over its largest component, so that its square neither overflows nor
/// vanishes; the zero vector stays zero.
pub fn tame_vector<R: Real>(v: Vec3<R>) -> Vec3<R> {
    let size = vec3(v.x.abs(), v.y.abs(), v.z.abs());
    let xy = if size.x > size.y { size.x } else { size.y };
    let largest = if xy > size.z { xy } else { size.z };
    if largest == R::ZERO {
        return v;
    }
    vec3(
        divide(v.x, largest),
        divide(v.y, largest),
        divide(v.z, largest),
    )
}

/// |v.x| + |v.y| + |v.z|: from |v| to 1.74 |v|, without a root.
pub fn taxicab_length<R: Real>(v: Vec3<R>) -> R {
    (v.x.abs() + v.y.abs()) + v.z.abs()
}

/// n, or -n where n points along `direction`, so that it faces who looks.
pub fn face_viewer<R: Real>(n: Vec3<R>, direction: Vec3<R>) -> Vec3<R> {
    if dot_product(n, direction) > R::ZERO {
        -n
    } else {
        n
    }
}

/// v / by, one division a component.
pub fn divided<R: Real>(v: Vec3<R>, by: R) -> Vec3<R> {
    vec3(divide(v.x, by), divide(v.y, by), divide(v.z, by))
}

/// The largest component of v.
pub fn largest_coordinate<R: Real>(v: Vec3<R>) -> R {
    let xy = if v.x > v.y { v.x } else { v.y };
    if xy > v.z { xy } else { v.z }
}

//! Sphere, as most textbooks have it: the baseline, not to be trusted far from its centre.

use super::camera::Ray;
use super::divide::{divide, square_root};
use super::real::{Real, constant};
use super::vector::{Vec3, dot_product};
use crate::layout::Sphere;

/// The smallest t > 0 at which the ray meets the sphere, or `MISS`: by b^2 - 4ac.
pub fn intersect_sphere<R: Real>(ray: Ray<R>, sphere: &Sphere<R>) -> R {
    let f = ray.origin - Vec3::from(sphere.center);
    let a = dot_product(ray.direction, ray.direction);
    let b = R::TWO * dot_product(f, ray.direction);
    let c = dot_product(f, f) - sphere.radius * sphere.radius;
    let discriminant = b * b - constant::<R>(4.0) * a * c;
    if discriminant < R::ZERO {
        return R::MISS;
    }
    let root = square_root(discriminant);
    let near = divide(-b - root, R::TWO * a);
    if near > R::ZERO {
        return near;
    }
    let far = divide(-b + root, R::TWO * a);
    if far > R::ZERO {
        return far;
    }
    R::MISS
}

/// The outward normal where the ray meets the sphere at `t`.
pub fn sphere_normal<R: Real>(ray: Ray<R>, sphere: &Sphere<R>, t: R) -> Vec3<R> {
    let from_center = (ray.origin + ray.direction * t) - Vec3::from(sphere.center);
    from_center * divide(constant(1.0), sphere.radius)
}

/// The point of the sphere that is met at `t`, under the outward normal.
pub fn sphere_point<R: Real>(_ray: Ray<R>, sphere: &Sphere<R>, normal: Vec3<R>, _t: R) -> Vec3<R> {
    Vec3::from(sphere.center) + normal * sphere.radius
}

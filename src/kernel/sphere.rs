//! Sphere: Haines, Günther, Akenine-Möller, "Precision Improvements for
//! Ray/Sphere Intersection", Ray Tracing Gems (2019), chapter 7.

use super::camera::Ray;
use super::divide::{divide, square_root};
use super::near_spheres::{sphere_power, starts_near};
use super::real::{Real, copy_sign};
use super::vector::{Vec3, dot_product, unit_vector};
use crate::layout::Sphere;

/// The smallest t > 0 at which the ray meets the sphere, or `MISS`.
///
/// The discriminant is taken at the ray's point nearest to the centre, where
/// nothing large cancels, and the small root comes from the large one. Near the surface
/// of a large sphere, and for rays from no farther than its size, see
/// [`super::near_spheres`].
pub fn intersect_sphere<R: Real>(ray: Ray<R>, sphere: &Sphere<R>) -> R {
    let f = ray.origin - Vec3::from(sphere.center);
    let d = ray.direction;
    let a = dot_product(d, d);
    let b = -dot_product(f, d);
    let c = sphere_power(ray.origin, sphere);
    let l = f + d * divide(b, a);
    let mut discriminant = sphere.radius * sphere.radius - dot_product(l, l);
    if starts_near(sphere, c) {
        discriminant = divide(b * b - a * c, a);
    }
    if discriminant < R::ZERO {
        return R::MISS;
    }
    let q = b + copy_sign(square_root(a * discriminant), b);
    if q == R::ZERO {
        return R::MISS;
    }
    let t0 = divide(c, q);
    let t1 = divide(q, a);
    let near = if t0 < t1 { t0 } else { t1 };
    let far = if t0 < t1 { t1 } else { t0 };
    if near > R::ZERO {
        return near;
    }
    if far > R::ZERO {
        return far;
    }
    R::MISS
}

/// The outward unit normal where the ray meets the sphere at `t`.
///
/// Measured from the centre along l, not as origin + t * direction: the error
/// is then relative to the radius, not to the distance. Near the surface both are
/// alike, and at the horizon what is left of the radius for l is a rounding.
pub fn sphere_normal<R: Real>(ray: Ray<R>, sphere: &Sphere<R>, t: R) -> Vec3<R> {
    let f = ray.origin - Vec3::from(sphere.center);
    let d = ray.direction;
    if starts_near(sphere, sphere_power(ray.origin, sphere)) {
        return unit_vector(f + d * t);
    }
    let a = dot_product(d, d);
    let middle = divide(-dot_product(f, d), a);
    let l = f + d * middle;
    let discriminant = sphere.radius * sphere.radius - dot_product(l, l);
    let half_chord = square_root(divide(discriminant, a));
    unit_vector(l + d * copy_sign(half_chord, t - middle))
}

/// The point of the sphere that is met at `t`, under the outward unit normal.
pub fn sphere_point<R: Real>(ray: Ray<R>, sphere: &Sphere<R>, normal: Vec3<R>, t: R) -> Vec3<R> {
    if starts_near(sphere, sphere_power(ray.origin, sphere)) {
        return ray.origin + ray.direction * t;
    }
    Vec3::from(sphere.center) + normal * sphere.radius
}

//! Spheres near whose surface the camera is, such as a planet under it.
//!
//! The power of a point is |p - c|^2 - r^2. There, two large squares almost cancel, and
//! with them what f32 knows of the height above the surface. So the host computes the
//! camera's own power before it rounds; from a point elsewhere, what is to be added has
//! the size of the way there.

use super::real::{Real, constant};
use super::vector::{Vec3, dot_product};
use crate::layout::Sphere;

/// In place of the power of a sphere that the camera is not near.
pub const FAR: f32 = f32::MAX;

/// Whether the camera's power is known.
pub fn is_near<R: Real>(sphere: &Sphere<R>) -> bool {
    sphere.power < constant(FAR)
}

/// Whether a ray whose origin has this power starts near such a sphere too. From afar its
/// discriminant is that of any sphere: made of powers, it would cancel.
pub fn starts_near<R: Real>(sphere: &Sphere<R>, power: R) -> bool {
    is_near(sphere) && power.abs() < sphere.radius * sphere.radius
}

/// The power of a ray's origin.
pub fn sphere_power<R: Real>(origin: Vec3<R>, sphere: &Sphere<R>) -> R {
    let center = Vec3::from(sphere.center);
    if is_near(sphere) {
        let way = dot_product(origin, origin) - R::TWO * dot_product(origin, center);
        return way + sphere.power;
    }
    let f = origin - center;
    dot_product(f, f) - sphere.radius * sphere.radius
}

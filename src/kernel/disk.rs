//! Disk: its plane, then the distance from its centre.

use super::camera::Ray;
use super::real::Real;
use super::vector::{Vec3, dot_product};
use super::{plane, plane_textbook};
use crate::layout::Disk;
use crate::tier::Formulas;

/// The t > 0 at which the ray meets the disk, its rim included, or `MISS`.
pub fn intersect_disk<R: Real>(ray: Ray<R>, disk: &Disk<R>) -> R {
    let center = Vec3::from(disk.center);
    let normal = Vec3::from(disk.normal);
    let t = match R::FORMULAS {
        Formulas::Textbook => plane_textbook::intersect_plane(ray, center, normal),
        _ => plane::intersect_plane(ray, center, normal),
    };
    let from_center = (ray.origin - center) + ray.direction * t;
    if dot_product(from_center, from_center) <= disk.radius * disk.radius {
        return t;
    }
    R::MISS
}

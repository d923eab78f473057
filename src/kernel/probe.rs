//! A ray with all that its tests share, computed once.

use super::aabb::{Slabs, slabs_of};
use super::camera::Ray;
use super::real::Real;
use super::triangle::{Shear, shear_of};

/// A ray with all that its tests share.
#[derive(Debug, Clone, Copy)]
pub struct Probe<R> {
    /// The ray.
    pub ray: Ray<R>,
    /// For boxes.
    pub slabs: Slabs,
    /// For triangles.
    pub shear: Shear<R>,
}

/// Prepares a ray.
pub fn probe_of<R: Real>(ray: Ray<R>) -> Probe<R> {
    Probe {
        ray,
        slabs: slabs_of(ray),
        shear: shear_of(ray),
    }
}

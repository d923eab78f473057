//! Paths in a tier.

use super::Widths;
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::kernel::real::Real;
use crate::paths::{Aim, Paths, check_aims};
use crate::render::Backend;
use crate::tier::Accuracy;
use crate::{cpu, gpu};

impl Widths {
    /// Follows the path of each ray in a tier, for so many legs: to the first surface, and on
    /// from there as the ray's aim has it. Directions are taken as they come, of whatever length.
    ///
    /// # Errors
    ///
    /// As [`Widths::trace_rays`]; [`Error::Usage`] where there is not one aim a ray, or no
    /// leg.
    pub fn follow_paths(
        &self,
        backend: &Backend,
        accuracy: Accuracy,
        rays: &[Ray<f32>],
        aims: &[Aim],
        legs: u32,
    ) -> Result<Paths> {
        if let Some(reason) = backend.lacks(accuracy) {
            return Err(Error::Usage(reason));
        }
        check_aims(rays, aims, legs)?;
        let (first, second) = (&self.bounded, &self.double);
        match (accuracy, backend) {
            (Accuracy::Textbook, _) => follow(backend, &self.textbook, rays, aims, legs),
            (Accuracy::Robust, _) => follow(backend, &self.robust, rays, aims, legs),
            (Accuracy::Extended, _) => follow(backend, &self.extended, rays, aims, legs),
            (Accuracy::Double, _) => follow(backend, &self.double, rays, aims, legs),
            (Accuracy::Adaptive, Backend::Cpu(threads)) => {
                cpu::paths::follow_adaptively(first, second, rays, aims, legs, *threads)
            }
            (Accuracy::Adaptive, Backend::Gpu(gpu)) => {
                gpu::paths::follow_adaptively(gpu, first, second, rays, aims, legs)
            }
        }
    }
}

fn follow<R: Real>(
    backend: &Backend,
    flat: &Flat<R>,
    rays: &[Ray<f32>],
    aims: &[Aim],
    legs: u32,
) -> Result<Paths> {
    match backend {
        Backend::Cpu(threads) => cpu::paths::follow_paths(flat, rays, aims, legs, *threads),
        Backend::Gpu(gpu) => gpu::paths::follow_paths(gpu, flat, rays, aims, legs),
    }
}

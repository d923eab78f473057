//! What a case is tried on.

use super::trials::grown::kind_of;
use crate::accuracy::Widths;
use crate::bounds::tree::{Tree, build};
use crate::error::Result;
use crate::found::Found;
use crate::gpu::selfcheck::Arithmetic;
use crate::kernel::aabb::Aabb;
use crate::kernel::camera::Ray;
use crate::layout::Pixel;
use crate::paths::{Aim, Paths};
use crate::render::{Accuracy, Backend};
use crate::scene::Scene;
use crate::watch::Unwatched;

/// What a case is tried on: a tier on a backend or, to show that the case can fail, formulas
/// broken on purpose.
pub trait Subject {
    /// By the bounds of which tier it is judged.
    fn tier(&self) -> Accuracy;

    /// The closest hit of each ray.
    ///
    /// # Errors
    ///
    /// Those of [`Widths::trace_rays`].
    fn trace_rays(&self, widths: &Widths, rays: &[Ray<f32>]) -> Result<Vec<Found>>;

    /// Whether a scene may be rendered.
    ///
    /// # Errors
    ///
    /// All its faults.
    fn validate(&self, scene: &Scene) -> Result<()> {
        scene.validate()
    }

    /// The picture from the scene's camera.
    ///
    /// # Errors
    ///
    /// Those of [`Widths::tracer`].
    fn picture(&self, widths: &Widths) -> Result<Vec<Pixel>>;

    /// What the legs of each ray's path find.
    ///
    /// # Errors
    ///
    /// Those of [`Widths::follow_paths`].
    fn follow_paths(
        &self,
        widths: &Widths,
        rays: &[Ray<f32>],
        aims: &[Aim],
        legs: u32,
    ) -> Result<Paths>;

    /// What its arithmetic does.
    fn arithmetic(&self) -> Arithmetic;

    /// A tree over boxes of spheres and triangles, as [`kind_of`] has it.
    fn grow(&self, items: Vec<(Aabb, u32)>) -> Tree {
        build(items, &kind_of)
    }
}

/// A tier on a backend that has it.
#[derive(Debug, Clone, Copy)]
pub struct Station<'a> {
    /// What traces.
    pub backend: &'a Backend,
    /// In what numbers, and by which formulas.
    pub tier: Accuracy,
}

impl Station<'_> {
    /// Why the backend does not have the tier, if it does not.
    pub fn lacks(&self) -> Option<String> {
        self.backend.lacks(self.tier)
    }

    /// Whether numbers are two f32, at least in the second pass, on a device that makes
    /// denormal ones 0.
    pub fn loses_halves(&self) -> bool {
        let Backend::Gpu(gpu) = self.backend else {
            return false;
        };
        let is_two = match self.tier {
            Accuracy::Extended => true,
            Accuracy::Adaptive => !gpu.arithmetic.f64,
            _ => false,
        };
        is_two && !gpu.arithmetic.denormals
    }
}

impl Subject for Station<'_> {
    fn tier(&self) -> Accuracy {
        self.tier
    }

    fn trace_rays(&self, widths: &Widths, rays: &[Ray<f32>]) -> Result<Vec<Found>> {
        let found = widths.trace_rays(self.backend, self.tier, rays)?;
        Ok(found.0)
    }

    fn picture(&self, widths: &Widths) -> Result<Vec<Pixel>> {
        let mut picture = Vec::new();
        let mut tracer = widths.tracer(self.backend, self.tier, false)?;
        tracer.run(&Unwatched, &mut |_, rows| picture.extend_from_slice(rows))?;
        Ok(picture)
    }

    fn follow_paths(
        &self,
        widths: &Widths,
        rays: &[Ray<f32>],
        aims: &[Aim],
        legs: u32,
    ) -> Result<Paths> {
        widths.follow_paths(self.backend, self.tier, rays, aims, legs)
    }

    fn arithmetic(&self) -> Arithmetic {
        match self.backend {
            // Rust's is that of IEEE 754.
            Backend::Cpu(_) => Arithmetic {
                two_sum: true,
                two_prod: true,
                ..Arithmetic::default()
            },
            Backend::Gpu(gpu) => gpu.arithmetic.clone(),
        }
    }
}

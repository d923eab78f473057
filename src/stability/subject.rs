//! What a case is tried on.

use super::grown::kind_of;
use crate::accuracy::Widths;
use crate::bounds::tree::{Tree, build};
use crate::error::Result;
use crate::found::Found;
use crate::kernel::aabb::Aabb;
use crate::kernel::camera::Ray;
use crate::layout::Pixel;
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
}

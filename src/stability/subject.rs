//! What a case is tried on.

use crate::accuracy::Widths;
use crate::error::Result;
use crate::found::Found;
use crate::kernel::camera::Ray;
use crate::render::{Accuracy, Backend};
use crate::scene::Scene;

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
}

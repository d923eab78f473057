//! What a case is tried on.

use crate::accuracy::Widths;
use crate::error::{Error, Result};
use crate::found::Found;
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

    /// The pixels of a picture, row by row.
    ///
    /// # Errors
    ///
    /// Those of [`Widths::tracer`]; [`Error::Usage`] where the subject traces rays only.
    fn trace_picture(&self, _widths: &Widths) -> Result<Vec<Pixel>> {
        Err(Error::Usage("this subject makes no pictures".into()))
    }

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

    fn trace_picture(&self, widths: &Widths) -> Result<Vec<Pixel>> {
        let mut pixels = Vec::new();
        let mut keep = |_row, rows: &[Pixel]| pixels.extend_from_slice(rows);
        let mut tracer = widths.tracer(self.backend, self.tier, false)?;
        tracer.run(&Unwatched, &mut keep)?;
        Ok(pixels)
    }
}

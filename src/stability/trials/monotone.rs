//! A shape that grows: a ray that met it goes on meeting it, and no later.

use crate::accuracy::Widths;
use crate::error::Result;
use crate::found::Found;
use crate::kernel::camera::Ray;
use crate::stability::case::Trial;
use crate::stability::subject::Subject;
use crate::stability::tally::{Tally, must};

/// Scenes of one shape, each with a larger one than the one before, and rays through all of
/// them.
pub struct Monotone {
    /// The scenes.
    pub growing: Vec<Widths>,
    /// The rays.
    pub rays: Vec<Ray<f32>>,
}

impl Trial for Monotone {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let trace = |widths: &Widths| on.trace_rays(widths, &self.rays);
        let found: Vec<Vec<Found>> = self.growing.iter().map(trace).collect::<Result<_>>()?;
        let mut tally = Tally::default();
        for ray in 0..self.rays.len() {
            // A miss is at infinity.
            let falls = |pair: &[Vec<Found>]| pair[1][ray].t <= pair[0][ray].t;
            let is_monotone = found.windows(2).all(falls);
            tally.count([must(is_monotone)]);
        }
        Ok(tally)
    }
}

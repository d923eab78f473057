//! Two sets of rays with one answer: what was changed must not matter.

use crate::accuracy::Widths;
use crate::error::Result;
use crate::kernel::camera::Ray;
use crate::layout::NO_HIT;
use crate::stability::case::Trial;
use crate::stability::demand::unit_of;
use crate::stability::subject::Subject;
use crate::stability::tally::{Tally, must};

/// Two scenes, a list of rays through each.
pub struct Alike {
    /// As it is.
    pub left: (Widths, Vec<Ray<f32>>),
    /// After the change.
    pub right: (Widths, Vec<Ray<f32>>),
    /// What t is multiplied with by the change, ray by ray.
    pub scale: Vec<f64>,
    /// By how many u of itself t may differ; 0 for the same bits.
    pub roundings: f64,
}

impl Trial for Alike {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let trace = |(widths, rays): &(Widths, Vec<Ray<f32>>)| on.trace_rays(widths, rays);
        let mut tally = Tally::default();
        let pairs = trace(&self.left)?.into_iter().zip(trace(&self.right)?);
        for ((left, right), scale) in pairs.zip(&self.scale) {
            let id_error = must(left.id == right.id);
            let is_hit = left.id != NO_HIT && left.id == right.id;
            let expected = left.t * scale;
            let off = (right.t - expected).abs() / (unit_of(on.tier()) * expected);
            let t_error = (if is_hit { off } else { 0.0 }, self.roundings);
            tally.count([id_error, t_error]);
        }
        Ok(tally)
    }
}

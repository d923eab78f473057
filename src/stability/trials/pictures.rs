//! A picture with volumes and one without: they must be the same.

use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::flat::Flat;
use crate::stability::case::Trial;
use crate::stability::subject::Subject;
use crate::stability::tally::{Tally, must};

/// A scene with volumes and without.
pub struct Pictures {
    bounded: Widths,
    by_force: Widths,
}

impl Pictures {
    /// Of a scene, seen from its camera.
    pub fn new(flat: Flat<f64>, bounds: Bounds) -> Self {
        Self {
            by_force: Widths::of(flat.clone(), Bounds::None),
            bounded: Widths::of(flat, bounds),
        }
    }
}

impl Trial for Pictures {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let mut tally = Tally::default();
        let [bounded, by_force] = [on.picture(&self.bounded)?, on.picture(&self.by_force)?];
        for (with, without) in bounded.iter().zip(&by_force) {
            let is_same = with.id == without.id && with.depth.to_bits() == without.depth.to_bits();
            tally.count([must(is_same)]);
        }
        Ok(tally)
    }
}

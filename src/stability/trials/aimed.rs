//! Rays through a scene, each held to the exact answer.

use crate::accuracy::{Truths, Widths};
use crate::bounds::Bounds;
use crate::error::Result;
use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::layout::NO_HIT;
use crate::oracle::{Oracle, ShapeKind, Truth};
use crate::stability::case::Trial;
use crate::stability::demand::{Answer, Demand};
use crate::stability::subject::Subject;
use crate::stability::tally::Tally;
use crate::watch::Unwatched;

/// Rays through a scene, with the exact answers.
pub struct Aimed {
    widths: Widths,
    by_force: Option<Widths>,
    rays: Vec<Ray<f32>>,
    truths: Vec<Truth>,
    demands: Vec<Demand>,
}

impl Aimed {
    /// Through a scene whose numbers are those of f32, by way of a tree or of none. Brute force
    /// is asked too where it is to be compared with.
    ///
    /// # Errors
    ///
    /// Those of [`Truths::of`].
    pub fn new(
        flat: Flat<f64>,
        bounds: Bounds,
        rays: Vec<Ray<f32>>,
        demands: &[Demand],
    ) -> Result<Self> {
        let is_compared = demands.contains(&Demand::BruteForce);
        let by_force = is_compared.then(|| Widths::of(flat.clone(), Bounds::None));
        let widths = Widths::of(flat, bounds);
        let exact: Vec<Ray<f64>> = rays.iter().map(|ray| ray.converted()).collect();
        let truths = Truths::of(&widths.double, &exact, &Unwatched)?.0;
        Ok(Self {
            widths,
            by_force,
            rays,
            truths,
            demands: demands.to_vec(),
        })
    }
}

/// Through a scene whose numbers are those of f32, by brute force.
///
/// # Errors
///
/// As [`Aimed::new`].
pub fn aimed(flat: Flat<f64>, rays: Vec<Ray<f32>>, demands: &[Demand]) -> Result<Box<dyn Trial>> {
    Ok(Box::new(Aimed::new(flat, Bounds::None, rays, demands)?))
}

impl Trial for Aimed {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let trace = |widths: &Widths| on.trace_rays(widths, &self.rays);
        let found = trace(&self.widths)?;
        let by_force = self.by_force.as_ref().map(trace).transpose()?;
        let flat = &self.widths.double;
        let oracle = Oracle::new(flat);
        let mut tally = Tally::default();
        for (index, (truth, found)) in self.truths.iter().zip(found).enumerate() {
            let shape = (truth.id != NO_HIT).then(|| {
                let kind = kind_of(flat, truth.id);
                oracle.shape(kind, truth.row).1
            });
            let answer = Answer {
                ray: self.rays[index].converted(),
                truth,
                shape,
                found,
                by_force: by_force.as_ref().map(|found| found[index]),
            };
            tally.count(
                self.demands
                    .iter()
                    .filter_map(|demand| demand.judge(&answer, on.tier())),
            );
        }
        Ok(tally)
    }
}

/// The kind of the primitive with an id.
fn kind_of(flat: &Flat<f64>, id: u32) -> ShapeKind {
    if (flat.first_plane()..flat.first_disk()).contains(&id) {
        return ShapeKind::Plane;
    }
    flat.kind_of(id).0.into()
}

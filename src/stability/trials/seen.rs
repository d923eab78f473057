//! The sphere of a scene as shading sees it: the points and the normals of a picture.

use glam::DVec3;

use crate::accuracy::truth::{Truths, exact_rays};
use crate::accuracy::{BAND, Widths};
use crate::bounds::Bounds;
use crate::error::Result;
use crate::flat::Flat;
use crate::layout::NO_HIT;
use crate::oracle::Truth;
use crate::stability::case::Trial;
use crate::stability::demand::unit_of;
use crate::stability::subject::Subject;
use crate::stability::tally::{Tally, must};
use crate::tier::Accuracy;
use crate::watch::Unwatched;

/// By how much a picture's ray may be off beside what a test is, in parts of its length: see
/// "Rays of a picture" in `docs/numerics.md`.
const OF_A_RAY: f64 = 8.0 / 16_777_216.0;

/// A picture of a sphere.
pub struct Seen {
    widths: Widths,
    truths: Vec<Truth>,
    roundings: f64,
}

impl Seen {
    /// Of a scene that has one shape, a sphere, of which points and normals are to be within so
    /// many roundings of the radius, and a normal along the point's way from the centre within
    /// as many of that point.
    ///
    /// # Errors
    ///
    /// Those of [`Truths::of`].
    pub fn new(flat: Flat<f64>, roundings: f64) -> Result<Self> {
        let truths = Truths::of(&flat, &exact_rays(&flat), &Unwatched)?.0;
        let widths = Widths::of(flat, Bounds::None);
        Ok(Self {
            widths,
            truths,
            roundings,
        })
    }
}

impl Trial for Seen {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let sphere = &self.widths.double.spheres[0];
        let (center, radius) = (DVec3::from(sphere.center), sphere.radius);
        // Pictures are f32 in every tier.
        let unit = unit_of(Accuracy::Robust);
        let mut tally = Tally::default();
        for (pixel, truth) in on.picture(&self.widths)?.iter().zip(&self.truths) {
            if pixel.id == NO_HIT {
                let is_clear = truth.id != NO_HIT && truth.margin > BAND + OF_A_RAY;
                tally.count([must(!is_clear)]);
                continue;
            }
            let vector = |v: [f32; 3]| DVec3::from(v.map(f64::from));
            let normal = vector(pixel.normal).length() - 1.0;
            // The sum with the centre is rounded once more, to parts of its own length.
            let from_center = vector(pixel.position) - center;
            let rounding = unit * (center.length() + radius);
            let off = (from_center.length() - radius).abs() - rounding;
            // All of these spheres are seen from outside.
            let turned = vector(pixel.normal).distance(from_center.normalize());
            tally.count([
                (normal.abs() / unit, self.roundings),
                (off.max(0.0) / (unit * radius), self.roundings),
                (turned * radius / rounding, self.roundings),
            ]);
        }
        Ok(tally)
    }
}

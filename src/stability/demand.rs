//! What a case demands of each ray's answer, and how it is judged.

use super::residual::{reach, residual};
use super::tally::must;
use crate::accuracy::BAND;
use crate::found::Found;
use crate::kernel::camera::Ray;
use crate::layout::NO_HIT;
use crate::oracle::Truth;
use crate::oracle::shape::Shape;
use crate::render::Accuracy;

/// The margin from which on a decision is clear in wider numbers than f32. The oracle computes
/// margins in f64, from lengths that cancel: below 2^-40 they tell nothing.
pub const CLEAR: f64 = 1.0 / (1_u64 << 40) as f64;

/// What a ray's answer must fulfil. u is the rounding of the tier's numbers, B = |o| + t |d| +
/// |c| + r the lengths concerned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Demand {
    /// Hit or miss, and the shape, as the oracle says outside of the tier's band: 16 u for f32,
    /// [`CLEAR`] for wider numbers.
    Classified,
    /// The same with the band of wider numbers in every tier.
    ClassifiedClearly,
    /// The same where f32 has a band of so many u, less than [`Demand::Classified`] has.
    ClassifiedWithin(f64),
    /// Hit or miss, and the shape, as the oracle says, whatever the margin: the numbers are such
    /// that nothing has to be rounded.
    Exact,
    /// The point at t is off the shape by at most so many u B.
    Residual(f64),
    /// t is off by at most so many u t.
    Distance(f64),
    /// The point at t is off the exact one, which is on the ray too, by at most so many u B.
    Along(f64),
    /// A ray into a closed surface meets it.
    NoLeak,
    /// A ray that leaves a surface does not meet it at once.
    NoSelfHit,
    /// t is a finite number above 0, or there is no hit.
    Finite,
    /// The tree gives what brute force gives, bit for bit.
    BruteForce,
    /// Two set-ups have the same answer: the same shape, and t within so many u t.
    Same(f64),
    /// The scene is refused, and the reason is told.
    Refused,
    /// As the case says.
    Own(&'static str),
}

/// The rounding unit of t in a tier. An adaptive t is that of f32 where the ray is not in doubt.
pub fn unit_of(tier: Accuracy) -> f64 {
    match tier {
        Accuracy::Textbook | Accuracy::Robust | Accuracy::Adaptive => 2f64.powi(-24),
        // The bound that `gpu::split` is tested for.
        Accuracy::Extended => 2f64.powi(-44),
        Accuracy::Double => 2f64.powi(-53),
    }
}

/// The margin up to which a tier may decide otherwise.
pub fn band_of(tier: Accuracy) -> f64 {
    match tier {
        Accuracy::Textbook | Accuracy::Robust => BAND,
        Accuracy::Extended | Accuracy::Double | Accuracy::Adaptive => CLEAR,
    }
}

/// A ray's answer, and the exact one.
pub struct Answer<'a> {
    /// The ray.
    pub ray: Ray<f64>,
    /// What it hits in truth.
    pub truth: &'a Truth,
    /// That shape.
    pub shape: Option<Shape<'a>>,
    /// What was found.
    pub found: Found,
    /// What brute force found, where it was asked.
    pub by_force: Option<Found>,
}

impl Demand {
    /// The error of an answer, and its bound; none where the demand is not one on answers.
    pub fn judge(self, answer: &Answer<'_>, tier: Accuracy) -> Option<(f64, f64)> {
        let Answer { truth, found, .. } = answer;
        let is_right = found.id == truth.id;
        let is_hit = found.id != NO_HIT;
        Some(match self {
            Self::Classified if is_right => (0.0, band_of(tier)),
            Self::Classified => (truth.margin, band_of(tier)),
            Self::ClassifiedClearly if is_right => (0.0, CLEAR),
            Self::ClassifiedClearly => (truth.margin, CLEAR),
            Self::ClassifiedWithin(roundings) => {
                let band = band_of(tier).min(roundings * unit_of(Accuracy::Robust));
                (if is_right { 0.0 } else { truth.margin }, band.max(CLEAR))
            }
            Self::Exact => must(is_right),
            Self::Residual(roundings) => match (&answer.shape, is_right && is_hit) {
                (Some(shape), true) => {
                    let scale = unit_of(tier) * reach(shape, answer.ray, found.t);
                    (residual(shape, answer.ray, found.t) / scale, roundings)
                }
                _ => (0.0, roundings),
            },
            Self::Distance(roundings) if is_right && is_hit => {
                let off = ((found.t - truth.t) - truth.t_rest).abs();
                (off / (unit_of(tier) * truth.t), roundings)
            }
            Self::Distance(roundings) => (0.0, roundings),
            Self::Along(roundings) => match (&answer.shape, is_right && is_hit) {
                (Some(shape), true) => {
                    let length = glam::DVec3::from(<[f64; 3]>::from(answer.ray.direction)).length();
                    let off = ((found.t - truth.t) - truth.t_rest).abs() * length;
                    let scale = unit_of(tier) * reach(shape, answer.ray, truth.t);
                    (off / scale, roundings)
                }
                _ => (0.0, roundings),
            },
            Self::NoLeak => must(is_hit),
            Self::Finite => must(!is_hit || (found.t.is_finite() && found.t > 0.0)),
            Self::BruteForce => must(answer.by_force.is_none_or(|by_force| {
                by_force.id == found.id && by_force.t.to_bits() == found.t.to_bits()
            })),
            Self::NoSelfHit | Self::Same(_) | Self::Refused | Self::Own(_) => return None,
        })
    }

    /// The demand for people.
    pub fn describe(self) -> String {
        match self {
            Self::Classified => "hit or miss, and the shape, as the oracle says".into(),
            Self::ClassifiedClearly => {
                "hit or miss, and the shape, as the oracle says, in f32 too".into()
            }
            Self::ClassifiedWithin(k) => {
                format!("hit or miss, and the shape, as the oracle says beyond {k} u of B")
            }
            Self::Exact => "the oracle's answer, to the last bit of the decision".into(),
            Self::Residual(k) => format!("the point is within {k} u B of the shape"),
            Self::Distance(k) => format!("t is within {k} u of itself"),
            Self::Along(k) => format!("the point is within {k} u B of the exact one"),
            Self::NoLeak => "no ray slips through".into(),
            Self::NoSelfHit => "no ray meets the surface that it leaves".into(),
            Self::Finite => "no NaN or infinity comes out".into(),
            Self::BruteForce => "the tree gives what brute force gives, bit for bit".into(),
            Self::Same(0.0) => "the same answer, bit for bit".into(),
            Self::Same(k) => format!("the same shape, and t within {k} u of itself"),
            Self::Refused => "the scene is refused, with the reason".into(),
            Self::Own(text) => text.into(),
        }
    }
}

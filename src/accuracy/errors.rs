//! How far a tracer's hits are from the exact ones.

use serde::Serialize;

use crate::found::Found;
use crate::frame::Verdict;
use crate::layout::NO_HIT;
use crate::oracle::Truth;

/// The band in which no f32 method can be blamed for deciding otherwise, in parts of the
/// lengths concerned: 16 roundings, as many as the stable formulas make.
pub const BAND: f64 = 16.0 / 16_777_216.0;

/// Errors of many rays.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Errors {
    /// Rays that hit nothing where they should, hit something where they should not, or hit
    /// the wrong primitive.
    pub misclassified: u64,
    /// Those of them outside of [`BAND`].
    pub outside_band: u64,
    /// Half of the others have a t that is off by no more ulp of f32 than this.
    pub ulp_p50: f64,
    /// 99 of 100.
    pub ulp_p99: f64,
    /// All.
    pub ulp_max: f64,
}

impl Errors {
    /// Of what a tracer found, against the truth, ray by ray.
    pub fn of(found: &[Found], truths: &[Truth]) -> Self {
        let mut errors = Self::default();
        let mut ulps = Vec::new();
        for (found, truth) in found.iter().zip(truths) {
            if found.id != truth.id {
                errors.misclassified += 1;
                errors.outside_band += u64::from(truth.margin > BAND);
            } else if found.id != NO_HIT {
                ulps.push(ulps_off(found, truth));
            }
        }
        ulps.sort_by(f64::total_cmp);
        [errors.ulp_p50, errors.ulp_p99, errors.ulp_max] =
            [0.5, 0.99, 1.0].map(|share| quantile(&ulps, share));
        errors
    }
}

/// The least value that `share` of all are not above; 0 of none.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.max(1) - 1).copied().unwrap_or(0.0)
}

/// By how many ulp of f32 the t of the right primitive is off.
pub fn ulps_off(found: &Found, truth: &Truth) -> f64 {
    ((found.t - truth.t) - truth.t_rest).abs() / ulp_of_f32(truth.t)
}

/// The distance of the f32 next to t, below 2^-126 that of the least ones.
fn ulp_of_f32(t: f64) -> f64 {
    let least = f64::from(f32::MIN_POSITIVE);
    let power = f64::from_bits(t.abs().max(least).to_bits() >> 52 << 52);
    power * f64::from(f32::EPSILON)
}

/// What a tracer made of a ray.
pub fn verdict(found: u32, truth: u32) -> Verdict {
    match (found, truth) {
        _ if found == truth => Verdict::Right,
        (NO_HIT, _) => Verdict::FalseMiss,
        (_, NO_HIT) => Verdict::FalseHit,
        _ => Verdict::WrongShape,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn truth(id: u32, t: f64, margin: f64) -> Truth {
        Truth {
            id,
            row: 0,
            t,
            t_rest: 0.0,
            margin,
        }
    }

    #[test]
    fn errors_are_told_apart() {
        let truths = [
            truth(1, 2.0, 0.5),
            truth(1, 2.0, 0.5),
            truth(2, 8.0, 0.5),
            truth(NO_HIT, f64::INFINITY, 1e-9),
        ];
        let ulp = 2.0 * f64::from(f32::EPSILON);
        let found = [
            Found::new(2.0 + 3.0 * ulp, 1),
            Found::new(2.0, 1),
            Found::new(8.0, 3),
            Found::new(1.0, 3),
        ];
        let errors = Errors::of(&found, &truths);
        assert_eq!((errors.misclassified, errors.outside_band), (2, 1));
        assert_eq!(
            (errors.ulp_p50, errors.ulp_p99, errors.ulp_max),
            (0.0, 3.0, 3.0)
        );
        // The control: what is right has no errors.
        let right = truths.map(|truth| Found::new(truth.t, truth.id));
        assert_eq!(Errors::of(&right, &truths), Errors::default());
    }

    #[test]
    fn an_ulp_is_that_of_f32() {
        for t in [1.0_f32, 1.5, 3.9, 1e-20, 1e20] {
            let above = f64::from(t.next_up()) - f64::from(t);
            assert_eq!(ulp_of_f32(t.into()), above, "{t}");
        }
    }

    #[test]
    fn verdicts_are_told_apart() {
        assert_eq!(verdict(1, 1), Verdict::Right);
        assert_eq!(verdict(NO_HIT, NO_HIT), Verdict::Right);
        assert_eq!(verdict(NO_HIT, 1), Verdict::FalseMiss);
        assert_eq!(verdict(1, NO_HIT), Verdict::FalseHit);
        assert_eq!(verdict(1, 2), Verdict::WrongShape);
    }
}

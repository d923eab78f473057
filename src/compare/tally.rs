//! Counting the differences of one layer.

use rayon::prelude::*;

use super::Tolerance;

/// Pixels that one task counts. Fixed, so that sums are taken in one order and
/// come out the same on any number of threads.
const CHUNK: usize = 4096;

/// How many floats lie between two, plus one: 0 for the same bits, 1 for
/// neighbours, -0 and +0 included. `u32::MAX` where just one is NaN.
pub fn ulp_distance(a: f32, b: f32) -> u32 {
    if a.is_nan() != b.is_nan() {
        return u32::MAX;
    }
    ordered(a).abs_diff(ordered(b))
}

/// Integers in the order of the floats: negative ones count down from -1.
fn ordered(value: f32) -> i32 {
    let bits = value.to_bits() as i32;
    if bits < 0 { !(bits & i32::MAX) } else { bits }
}

/// The values of one layer on both sides, `components` a pixel.
pub(super) struct Pair<'a> {
    pub name: String,
    pub components: usize,
    pub values: Values<'a>,
}

/// One layer's values, left and right.
pub(super) enum Values<'a> {
    Float(&'a [f32], &'a [f32]),
    /// Codes on the scale of 16 bits, of which `step` is one in the file.
    Code {
        left: &'a [u16],
        right: &'a [u16],
        step: u16,
    },
    Id(&'a [u32], &'a [u32]),
}

/// What is known about a pixel once all layers are counted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Mark {
    /// Some bit differs.
    pub different: bool,
    /// Some value is out of tolerance.
    pub outside: bool,
}

/// The differences of one layer, summed up.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Tally {
    pub different_pixels: u64,
    pub max_abs: f64,
    pub max_ulp: u32,
    pub square_sum: f64,
}

/// The difference of two values.
struct Gap {
    same: bool,
    /// Whether a tolerance has a say.
    tolerable: bool,
    abs: f64,
    ulp: u32,
}

impl Gap {
    fn within(&self, tolerance: &Tolerance) -> bool {
        let by_ulp = tolerance.max_ulp > 0 && self.ulp <= tolerance.max_ulp;
        let by_abs = tolerance.max_abs > 0.0 && self.abs <= tolerance.max_abs;
        self.same || (self.tolerable && (by_ulp || by_abs))
    }
}

impl Pair<'_> {
    /// Counts this layer's differences and adds them to the pixels' marks.
    pub fn tally(&self, tolerance: &Tolerance, marks: &mut [Mark]) -> Tally {
        let chunks: Vec<Tally> = marks
            .par_chunks_mut(CHUNK)
            .enumerate()
            .map(|(chunk, marks)| self.tally_chunk(chunk * CHUNK, tolerance, marks))
            .collect();
        chunks.into_iter().fold(Tally::default(), Tally::plus)
    }

    fn tally_chunk(&self, first: usize, tolerance: &Tolerance, marks: &mut [Mark]) -> Tally {
        let mut tally = Tally::default();
        for (pixel, mark) in (first..).zip(marks) {
            let mut different = false;
            for component in 0..self.components {
                let gap = self.values.gap(pixel * self.components + component);
                different |= !gap.same;
                mark.outside |= !gap.within(tolerance);
                tally.max_abs = tally.max_abs.max(gap.abs);
                tally.max_ulp = tally.max_ulp.max(gap.ulp);
                tally.square_sum += gap.abs * gap.abs;
            }
            mark.different |= different;
            tally.different_pixels += u64::from(different);
        }
        tally
    }

    /// The greatest absolute difference of a pixel's components.
    pub fn abs_of_pixel(&self, pixel: usize) -> f64 {
        let first = pixel * self.components;
        (first..first + self.components).fold(0.0, |most, i| self.values.gap(i).abs.max(most))
    }
}

impl Values<'_> {
    fn gap(&self, i: usize) -> Gap {
        match *self {
            Self::Float(left, right) => float_gap(left[i], right[i]),
            Self::Code { left, right, step } => {
                let apart = left[i].abs_diff(right[i]);
                Gap {
                    same: apart == 0,
                    tolerable: true,
                    abs: f64::from(apart) / f64::from(u16::MAX),
                    ulp: u32::from(apart / step),
                }
            }
            // Ids have no distance.
            Self::Id(left, right) => Gap {
                same: left[i] == right[i],
                tolerable: false,
                abs: 0.0,
                ulp: 0,
            },
        }
    }
}

fn float_gap(a: f32, b: f32) -> Gap {
    let abs = if a == b || (a.is_nan() && b.is_nan()) {
        0.0
    } else if a.is_finite() && b.is_finite() {
        (f64::from(a) - f64::from(b)).abs()
    } else {
        f64::INFINITY
    };
    Gap {
        same: a.to_bits() == b.to_bits(),
        tolerable: true,
        abs,
        ulp: ulp_distance(a, b),
    }
}

impl Tally {
    pub fn plus(self, other: Self) -> Self {
        Self {
            different_pixels: self.different_pixels + other.different_pixels,
            max_abs: self.max_abs.max(other.max_abs),
            max_ulp: self.max_ulp.max(other.max_ulp),
            square_sum: self.square_sum + other.square_sum,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ulp_distances_by_hand() {
        let tiny = f32::from_bits(1);
        let cases = [
            (1.0, 1.0, 0),
            (1.0, 1.0 + f32::EPSILON, 1),
            (1.0, 2.0, 1 << 23),
            (0.0, tiny, 1),
            (-0.0, 0.0, 1),
            (-tiny, tiny, 3),
            (f32::MAX, f32::INFINITY, 1),
            (f32::NAN, f32::NAN, 0),
            (f32::NAN, f32::from_bits(f32::NAN.to_bits() + 2), 2),
            (f32::NAN, 1.0, u32::MAX),
            (-f32::NAN, f32::NEG_INFINITY, u32::MAX),
            (f32::NEG_INFINITY, f32::INFINITY, 2 * 0x7F80_0000 + 1),
        ];
        for (a, b, distance) in cases {
            assert_eq!(ulp_distance(a, b), distance, "{a} {b}");
            assert_eq!(ulp_distance(b, a), distance, "{b} {a}");
        }
    }

    #[test]
    fn gaps_of_what_is_not_finite() {
        let inf = f32::INFINITY;
        assert_eq!(float_gap(inf, inf).abs, 0.0);
        assert_eq!(float_gap(inf, -inf).abs, f64::INFINITY);
        assert_eq!(float_gap(inf, 0.0).abs, f64::INFINITY);
        assert_eq!(float_gap(f32::NAN, 0.0).abs, f64::INFINITY);
        assert_eq!(float_gap(f32::NAN, -f32::NAN).abs, 0.0);
        assert!(!float_gap(f32::NAN, -f32::NAN).same);
        // f64 holds what f32 would overflow on.
        assert_eq!(
            float_gap(f32::MAX, -f32::MAX).abs,
            2.0 * f64::from(f32::MAX)
        );
    }
}

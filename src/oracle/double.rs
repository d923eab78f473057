//! Two f64, the sum of which has some 106 bits, with a bound on its error: decides what
//! [`super::filter`] leaves open, and gives t with more bits than it is asked for.
//!
//! Joldes, Muller, Popescu, "Tight and Rigorous Error Bounds for Basic Building Blocks of
//! Double-Word Arithmetic", ACM TOMS 44(2), 2017: the sum here (algorithm 6) is off by at
//! most 3 u^2 + 13 u^3, the product (algorithm 10) by 7 u^2, relative. A quotient and a
//! root need no such theorem: the bound is measured from their remainder.

use std::cmp::Ordering;

use super::filter::{INFLATE, TINY, UNIT};
use super::number::{Divide, Number};

/// The rounding of a sum or a product: more than 7 u^2.
const UNIT_SQUARED: f64 = 8.0 * UNIT * UNIT;

/// A number within `error` of `high` + `low`.
#[derive(Debug, Clone, Copy)]
pub struct Double {
    /// The nearest f64 of the sum.
    pub high: f64,
    /// The rest.
    pub low: f64,
    /// How far the sum is off at most.
    pub error: f64,
}

/// The rounded sum and what it lacks, exactly. Knuth's.
#[inline]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let from_b = sum - a;
    let from_a = sum - from_b;
    (sum, (a - from_a) + (b - from_b))
}

/// As [`two_sum`], where |a| >= |b| or a is 0. Dekker's.
#[inline]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// A number as the sum of two of 26 bits. Veltkamp's.
#[inline]
fn halves(a: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// The rounded product and what it lacks, exactly unless it underflows. Dekker's: a fused
/// operation would be a call where the processor is not known to have one.
#[inline]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let (a_high, a_low) = halves(a);
    let (b_high, b_low) = halves(b);
    let rest = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, rest)
}

impl Double {
    /// A quotient or a root: off by the remainder over `least` at most.
    #[inline]
    fn measured(high: f64, low: f64, remainder: Self, least: f64) -> Self {
        let size = remainder.high.abs() + remainder.low.abs() + remainder.error;
        let error = if least > 0.0 {
            size / least * INFLATE + TINY
        } else {
            f64::INFINITY
        };
        Self { high, low, error }
    }
}

impl Number for Double {
    #[inline]
    fn exact(value: f64) -> Self {
        Self {
            high: value,
            low: 0.0,
            error: 0.0,
        }
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        let (sum, rest) = two_sum(self.high, other.high);
        let (low_sum, low_rest) = two_sum(self.low, other.low);
        let (sum, rest) = quick_two_sum(sum, rest + low_sum);
        let (high, low) = quick_two_sum(sum, low_rest + rest);
        Self {
            high,
            low,
            error: (self.error + other.error + UNIT_SQUARED * high.abs()) * INFLATE,
        }
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        self.plus(&Self {
            high: -other.high,
            low: -other.low,
            error: other.error,
        })
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        let (product, rest) = two_product(self.high, other.high);
        let crossed = self.high * other.low + self.low * other.high;
        let (high, low) = quick_two_sum(product, rest + crossed);
        let from_other = (self.high.abs() + self.error) * other.error;
        let from_self = other.high.abs() * self.error;
        Self {
            high,
            low,
            // |high + low| is at most (1 + u) |high|, well within INFLATE.
            error: (from_other + from_self + UNIT_SQUARED * high.abs()) * INFLATE + TINY,
        }
    }

    #[inline]
    fn sign(&self) -> Option<Ordering> {
        // |low| is at most u |high|.
        let size = self.high.abs() * (1.0 - f64::EPSILON);
        if size > self.error {
            self.high.partial_cmp(&0.0)
        } else if self.high == 0.0 && self.error == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
}

impl Divide for Double {
    #[inline]
    fn over(&self, divisor: &Self) -> Self {
        let first = self.high / divisor.high;
        let left = self.minus(&divisor.times(&Self::exact(first)));
        let (high, low) = quick_two_sum(first, left.high / divisor.high);
        let quotient = Self {
            high,
            low,
            error: 0.0,
        };
        let remainder = self.minus(&divisor.times(&quotient));
        let least = divisor.high.abs() * (1.0 - 2.0 * f64::EPSILON) - divisor.error;
        Self::measured(high, low, remainder, least)
    }

    #[inline]
    fn square_root(&self) -> Self {
        if self.high == 0.0 && self.error == 0.0 {
            return *self;
        }
        let first = self.high.sqrt();
        let guess = Self::exact(first);
        let left = self.minus(&guess.times(&guess));
        let (high, low) = quick_two_sum(first, left.high / (2.0 * first));
        let root = Self {
            high,
            low,
            error: 0.0,
        };
        let remainder = self.minus(&root.times(&root));
        Self::measured(high, low, remainder, high * (1.0 - 2.0 * f64::EPSILON))
    }
}

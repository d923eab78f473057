//! f64 with a bound on its error: decides nearly everything.

use std::cmp::Ordering;

use super::number::{Divide, Number};

/// The rounding unit of f64.
pub(super) const UNIT: f64 = f64::EPSILON / 2.0;

/// A bound is a sum of at most six non-negative terms of at most two products each. Each
/// step rounds by a factor of 1 - u at worst, fewer than 14 of them, so this makes up for
/// all.
pub(super) const INFLATE: f64 = 1.0 + 16.0 * f64::EPSILON;

/// More than what a product loses by underflow, in its value and in the terms of its
/// bound: at most four times half the smallest number above zero.
pub(super) const TINY: f64 = f64::MIN_POSITIVE;

/// A number within `error` of `value`.
///
/// Running error analysis, Higham, "Accuracy and Stability of Numerical Algorithms", 2nd
/// ed., section 3.3: with |x - X| <= e and |y - Y| <= f, of a sum X + Y the rounded one is
/// off by e + f + u |fl(x + y)|; of a product X Y by |x| f + |y| e + e f + u |fl(x y)|. An
/// overflow gives infinities or NaN, and those compare as "not certain".
#[derive(Debug, Clone, Copy)]
pub struct Bounded {
    /// The computed number.
    pub value: f64,
    /// How far it is off at most.
    pub error: f64,
}

impl Bounded {
    /// Ends of an interval that holds the number.
    pub fn ends(self) -> [f64; 2] {
        let [low, high] = [self.value - self.error, self.value + self.error];
        if low.is_finite() && high.is_finite() {
            return [low.next_down(), high.next_up()];
        }
        [f64::NEG_INFINITY, f64::INFINITY]
    }
}

impl Number for Bounded {
    #[inline]
    fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        let value = self.value + other.value;
        Self {
            value,
            error: (self.error + other.error + UNIT * value.abs()) * INFLATE,
        }
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        let value = self.value - other.value;
        Self {
            value,
            error: (self.error + other.error + UNIT * value.abs()) * INFLATE,
        }
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        let value = self.value * other.value;
        let from_other = (self.value.abs() + self.error) * other.error;
        let from_self = other.value.abs() * self.error;
        Self {
            value,
            error: (from_other + from_self + UNIT * value.abs()) * INFLATE + TINY,
        }
    }

    #[inline]
    fn sign(&self) -> Option<Ordering> {
        if self.value > self.error {
            Some(Ordering::Greater)
        } else if -self.value > self.error {
            Some(Ordering::Less)
        } else if self.value == 0.0 && self.error == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
}

impl Divide for Bounded {
    /// |x/y - X/Y| <= (e + |x/y| f) / (|y| - f), and the quotient's rounding.
    #[inline]
    fn over(&self, divisor: &Self) -> Self {
        let value = self.value / divisor.value;
        let least = divisor.value.abs() * (1.0 - f64::EPSILON) - divisor.error;
        if least.is_nan() || least <= 0.0 {
            return Self {
                value,
                error: f64::INFINITY,
            };
        }
        // The factor 1 + 2u: the quotient in the bound is the rounded one.
        let from_divisor = value.abs() * (1.0 + f64::EPSILON) * divisor.error;
        Self {
            value,
            error: ((self.error + from_divisor) / least + UNIT * value.abs()) * INFLATE + TINY,
        }
    }

    /// |root x - root X| = |x - X| / (root x + root X) <= e / root x.
    #[inline]
    fn square_root(&self) -> Self {
        if self.value == 0.0 && self.error == 0.0 {
            return *self;
        }
        let value = self.value.sqrt();
        Self {
            value,
            error: (self.error / value * (1.0 + f64::EPSILON) + UNIT * value) * INFLATE,
        }
    }
}

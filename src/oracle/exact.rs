//! Exact numbers: an integer times a power of two.
//!
//! Every f64 is one, and so are sums and products of them. Quotients and roots are not;
//! those are taken to [`BITS`] bits, and no decision rests on them.

use std::cmp::Ordering;

use dashu_base::{Abs, BitTest, Signed, SquareRoot, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::number::{Divide, Number};

/// Bits of a quotient or a root, at least.
pub const BITS: isize = 256;

/// `integer` times two to the `exponent`.
#[derive(Debug, Clone)]
pub struct Exact {
    integer: IBig,
    exponent: isize,
}

impl Exact {
    /// The number times two to the `power`.
    pub fn scaled(&self, power: isize) -> Self {
        Self {
            integer: self.integer.clone(),
            exponent: self.exponent + power,
        }
    }

    /// The number less those of its bits that are worth less than two to the `exponent`.
    fn integer_at(&self, exponent: isize) -> IBig {
        let shift = self.exponent - exponent;
        if shift >= 0 {
            &self.integer << shift as usize
        } else {
            &self.integer >> (-shift) as usize
        }
    }

    fn bits(&self) -> isize {
        self.integer.bit_len() as isize
    }

    /// The nearest f64, and the nearest f64 of the difference.
    pub fn to_f64(&self) -> [f64; 2] {
        let nearest = self.nearest();
        if !nearest.is_finite() {
            return [nearest, 0.0];
        }
        [nearest, self.minus(&Self::exact(nearest)).nearest()]
    }

    /// The nearest f64.
    pub fn nearest(&self) -> f64 {
        // 62 bits and one that tells whether any below them is set round as all would.
        let shift = (self.bits() - 62).max(0) as usize;
        let size = self.integer.clone().unsigned_abs();
        let top = &size >> shift;
        let has_rest = (&top << shift) != size;
        let top = u64::try_from(top).expect("62 bits") << 1 | u64::from(has_rest);
        let magnitude = scale(top as f64, self.exponent + shift as isize - 1);
        if self.integer.is_negative() {
            -magnitude
        } else {
            magnitude
        }
    }
}

/// value * 2^exponent, in steps that overflow only where the result does.
pub fn scale(mut value: f64, mut exponent: isize) -> f64 {
    while exponent != 0 && value != 0.0 && value.is_finite() {
        let step = exponent.clamp(-1000, 1000);
        value *= f64::from_bits(((1023 + step) as u64) << 52);
        exponent -= step;
    }
    value
}

impl Number for Exact {
    /// # Panics
    ///
    /// When the number is not finite.
    fn exact(value: f64) -> Self {
        assert!(value.is_finite(), "{value} is no number");
        let bits = value.to_bits();
        let biased = ((bits >> 52) & 0x7ff) as isize;
        let fraction = bits & ((1 << 52) - 1);
        let size = if biased == 0 {
            fraction
        } else {
            fraction | 1 << 52
        };
        if size == 0 {
            return Self {
                integer: IBig::ZERO,
                exponent: 0,
            };
        }
        // Without the zeros at its end an f32 takes half the room, its products too.
        let zeros = size.trailing_zeros();
        let size = (size >> zeros) as i64;
        Self {
            integer: IBig::from(if value < 0.0 { -size } else { size }),
            exponent: biased.max(1) - 1075 + zeros as isize,
        }
    }

    fn plus(&self, other: &Self) -> Self {
        if self.integer.is_zero() {
            return other.clone();
        }
        if other.integer.is_zero() {
            return self.clone();
        }
        let exponent = self.exponent.min(other.exponent);
        Self {
            integer: self.integer_at(exponent) + other.integer_at(exponent),
            exponent,
        }
    }

    fn minus(&self, other: &Self) -> Self {
        self.plus(&Self {
            integer: -&other.integer,
            exponent: other.exponent,
        })
    }

    fn times(&self, other: &Self) -> Self {
        Self {
            integer: &self.integer * &other.integer,
            exponent: self.exponent + other.exponent,
        }
    }

    fn sign(&self) -> Option<Ordering> {
        Some(self.integer.cmp(&IBig::ZERO))
    }
}

impl Divide for Exact {
    /// To [`BITS`] bits.
    fn over(&self, divisor: &Self) -> Self {
        let shift = (BITS + divisor.bits() - self.bits()).max(0);
        Self {
            integer: (&self.integer << shift as usize) / &divisor.integer,
            exponent: self.exponent - shift - divisor.exponent,
        }
    }

    /// To [`BITS`] bits.
    fn square_root(&self) -> Self {
        let mut shift = (2 * BITS - self.bits()).max(0);
        shift += (self.exponent - shift).rem_euclid(2);
        let integer = &self.integer << shift as usize;
        let root: UBig = integer.abs().unsigned_abs().sqrt();
        Self {
            integer: root.into(),
            exponent: (self.exponent - shift) / 2,
        }
    }
}

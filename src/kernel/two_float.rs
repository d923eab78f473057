//! Arithmetic in two f32: a number is the unevaluated sum of a `high` one and of a
//! `low` one, what `high` lacks. Some 48 bits, on devices without f64.
//!
//! What the functions promise holds where f32's own `+ - *` round to nearest and are kept as
//! written, and nothing overflows or falls below the least normal number: products
//! need to lie above 2^-78. `u` below is 2^-24. No fused operation occurs, for a
//! device need not have one.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use bytemuck::{Pod, Zeroable};

use super::real::Real;
use crate::tier::{Formulas, Width};

/// The number high + low, where high is that sum rounded to f32.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, PartialEq, Pod, Zeroable)]
pub struct TwoFloat {
    /// The number, rounded.
    pub high: f32,
    /// What that lacks.
    pub low: f32,
}

/// a + b and its error, exactly. Dekker, "A floating-point technique for extending
/// the available precision", Numerische Mathematik 18, 1971: where a is 0 or its
/// exponent is at least b's.
pub fn quick_two_sum(a: f32, b: f32) -> TwoFloat {
    let high = a + b;
    let low = b - (high - a);
    TwoFloat { high, low }
}

/// a + b and its error, exactly. Knuth, The Art of Computer Programming 2, 4.2.2,
/// theorem B.
pub fn two_sum(a: f32, b: f32) -> TwoFloat {
    let high = a + b;
    let part = high - a;
    let low = (a - (high - part)) + (b - part);
    TwoFloat { high, low }
}

/// The upper 12 bits of the mantissa; 12 are left for the rest.
pub fn upper_half(a: f32) -> f32 {
    f32::from_bits(a.to_bits() & 0xffff_f000)
}

/// a b and its error, exactly. Dekker (1971), with the split by a mask: each product
/// of two halves has 24 bits.
pub fn two_product(a: f32, b: f32) -> TwoFloat {
    let high = a * b;
    let a_high = upper_half(a);
    let a_low = a - a_high;
    let b_high = upper_half(b);
    let b_low = b - b_high;
    let low = ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low;
    TwoFloat { high, low }
}

/// The integer, exactly: each half of it has 16 bits.
pub fn two_from_u32(value: u32) -> TwoFloat {
    quick_two_sum((value & 0xffff_0000) as f32, (value & 0xffff) as f32)
}

/// -a.
pub fn negate_two(a: TwoFloat) -> TwoFloat {
    TwoFloat {
        high: -a.high,
        low: -a.low,
    }
}

/// |a|.
pub fn absolute_two(a: TwoFloat) -> TwoFloat {
    if a.high < 0.0 { negate_two(a) } else { a }
}

/// a + b, with a relative error below 3 u^2 / (1 - 4 u). Joldes, Muller, Popescu,
/// "Tight and rigorous error bounds for basic building blocks of double-word
/// arithmetic", ACM TOMS 44(2), 2017: algorithm 6, AccurateDWPlusDW.
pub fn add_two(a: TwoFloat, b: TwoFloat) -> TwoFloat {
    let high = two_sum(a.high, b.high);
    let low = two_sum(a.low, b.low);
    let sum = quick_two_sum(high.high, high.low + low.high);
    quick_two_sum(sum.high, low.low + sum.low)
}

/// a - b, likewise.
pub fn subtract_two(a: TwoFloat, b: TwoFloat) -> TwoFloat {
    add_two(a, negate_two(b))
}

/// a b, with a relative error below 5 u^2; the same as b a. Joldes, Muller, Popescu
/// (2017): algorithm 10, DWTimesDW1. Their bound of 7 u^2 was lowered by Muller,
/// Rideau, "Formalization of double-word arithmetic", ACM TOMS 48(1), 2022.
pub fn multiply_two(a: TwoFloat, b: TwoFloat) -> TwoFloat {
    let product = two_product(a.high, b.high);
    let across = a.high * b.low + a.low * b.high;
    quick_two_sum(product.high, product.low + across)
}

/// a b for an f32 b, with a relative error below 2 u^2. Joldes, Muller, Popescu
/// (2017): algorithm 7, DWTimesFP1.
pub fn scale_two(a: TwoFloat, b: f32) -> TwoFloat {
    let product = two_product(a.high, b);
    let sum = quick_two_sum(product.high, a.low * b);
    quick_two_sum(sum.high, sum.low + product.low)
}

/// a / b, with a relative error below 15 u^2 + 56 u^3. Joldes, Muller, Popescu
/// (2017): algorithm 17, DWDivDW2.
pub fn divide_two(a: TwoFloat, b: TwoFloat) -> TwoFloat {
    let quotient = a.high / b.high;
    let product = scale_two(b, quotient);
    let rest = (a.high - product.high) + (a.low - product.low);
    quick_two_sum(quotient, rest / b.high)
}

/// The square root of a, with a relative error below 25/8 u^2; 0 of 0. Lefèvre,
/// Louvet, Muller, Picot, Rideau, "Accurate calculation of Euclidean norms using
/// double-word arithmetic", ACM TOMS 49(1), 2023: SQRTDWtoDW, a step of Karp and
/// Markstein's; with the square's error from [`two_product`].
pub fn square_root_two(a: TwoFloat) -> TwoFloat {
    if a.high == 0.0 {
        return a;
    }
    let root = a.high.sqrt();
    let square = two_product(root, root);
    let rest = ((a.high - square.high) - square.low) + a.low;
    quick_two_sum(root, rest / (2.0 * root))
}

/// a < b.
pub fn less_two(a: TwoFloat, b: TwoFloat) -> bool {
    a.high < b.high || (a.high == b.high && a.low < b.low)
}

/// a <= b.
pub fn less_or_equal_two(a: TwoFloat, b: TwoFloat) -> bool {
    a.high < b.high || (a.high == b.high && a.low <= b.low)
}

/// a = b.
pub fn equal_two(a: TwoFloat, b: TwoFloat) -> bool {
    a.high == b.high && a.low == b.low
}

/// The smaller of two numbers.
pub fn least_two(a: TwoFloat, b: TwoFloat) -> TwoFloat {
    if less_two(b, a) { b } else { a }
}

/// The larger of two numbers.
pub fn greatest_two(a: TwoFloat, b: TwoFloat) -> TwoFloat {
    if less_two(a, b) { b } else { a }
}

macro_rules! impl_operator {
    ($operator:ident, $method:ident, $function:ident) => {
        impl $operator for TwoFloat {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                $function(self, other)
            }
        }
    };
}

impl_operator!(Add, add, add_two);
impl_operator!(Sub, sub, subtract_two);
impl_operator!(Mul, mul, multiply_two);
impl_operator!(Div, div, divide_two);

impl Neg for TwoFloat {
    type Output = Self;
    fn neg(self) -> Self {
        negate_two(self)
    }
}

impl PartialOrd for TwoFloat {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.high.partial_cmp(&other.high) {
            Some(Ordering::Equal) => self.low.partial_cmp(&other.low),
            order => order,
        }
    }
    fn lt(&self, other: &Self) -> bool {
        less_two(*self, *other)
    }
    fn le(&self, other: &Self) -> bool {
        less_or_equal_two(*self, *other)
    }
    fn gt(&self, other: &Self) -> bool {
        less_two(*other, *self)
    }
    fn ge(&self, other: &Self) -> bool {
        less_or_equal_two(*other, *self)
    }
}

impl Real for TwoFloat {
    const FORMULAS: Formulas = Formulas::Stable;
    const WIDTH: Width = Width::Extended;
    const ZERO: Self = Self {
        high: 0.0,
        low: 0.0,
    };
    const TWO: Self = Self {
        high: 2.0,
        low: 0.0,
    };
    const MISS: Self = Self {
        high: f32::MAX,
        low: 0.0,
    };

    fn from_f64(value: f64) -> Self {
        let high = value as f32;
        let low = if high.is_finite() {
            (value - f64::from(high)) as f32
        } else {
            0.0
        };
        Self { high, low }
    }
    fn from_u32(value: u32) -> Self {
        two_from_u32(value)
    }
    fn to_f32(self) -> f32 {
        self.high
    }
    fn to_f64(self) -> f64 {
        f64::from(self.high) + f64::from(self.low)
    }
    /// Not correctly rounded, see [`square_root_two`].
    fn sqrt(self) -> Self {
        square_root_two(self)
    }
    fn abs(self) -> Self {
        absolute_two(self)
    }
    /// By a comparison, as the shader does: a zero counts as positive.
    fn copysign(self, sign: Self) -> Self {
        let magnitude = absolute_two(self);
        if less_two(sign, Self::ZERO) {
            negate_two(magnitude)
        } else {
            magnitude
        }
    }
}

#[cfg(test)]
mod tests;

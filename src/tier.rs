//! The accuracy tiers: two axes, formulas and width.
//!
//! A tier is a number type of the kernel, and a choice of files of the shader.

use std::ops::{Add, Div, Mul, Neg, Sub};

use bytemuck::{Pod, Zeroable};
use serde::Serialize;

use crate::kernel::real::Real;
use crate::kernel::two_float::TwoFloat;

/// Which formulas the shapes are tested by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Formulas {
    /// Those of a textbook.
    Textbook,
    /// Stable ones.
    Stable,
    /// Stable ones that bound their own error.
    Bounded,
}

/// How wide the numbers of the geometry are. Shading is f32 in each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Width {
    /// f32: 24 bits.
    Single,
    /// The sum of two f32: 48 bits.
    Extended,
    /// f64: 53 bits.
    Double,
}

impl Width {
    /// How many f32 hold a number, as the shaders read it.
    pub const fn parts(self) -> usize {
        match self {
            Self::Single => 1,
            Self::Extended => 2,
            Self::Double => 3,
        }
    }
}

/// The f32 whose sum the number is, the largest first, as many as its width has parts.
pub fn parts_of<R: Real>(number: R) -> [f32; 3] {
    let value = number.to_f64();
    let first = value as f32;
    let rest = value - f64::from(first);
    let second = rest as f32;
    [first, second, (rest - f64::from(second)) as f32]
}

/// How accurately rays are traced.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Accuracy {
    /// The formulas of a textbook in f32.
    Textbook,
    /// Stable formulas in f32.
    #[default]
    Robust,
    /// Stable formulas in two f32.
    Extended,
    /// Stable formulas in f64, scene and rays unrounded.
    Double,
    /// Stable formulas in f32 that bound their own error; rays in doubt once more in f64.
    Adaptive,
}

impl Accuracy {
    /// Every tier.
    pub const ALL: [Self; 5] = [
        Self::Textbook,
        Self::Robust,
        Self::Extended,
        Self::Double,
        Self::Adaptive,
    ];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Textbook => "textbook",
            Self::Robust => "robust",
            Self::Extended => "extended",
            Self::Double => "double",
            Self::Adaptive => "adaptive",
        }
    }
}

macro_rules! single_numbers {
    ($($(#[$doc:meta])* $name:ident $formulas:ident)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, Default, PartialEq, PartialOrd, Pod, Zeroable)]
        #[repr(transparent)]
        pub struct $name(pub f32);

        impl Add for $name {
            type Output = Self;
            #[inline]
            fn add(self, other: Self) -> Self { Self(self.0 + other.0) }
        }
        impl Sub for $name {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self { Self(self.0 - other.0) }
        }
        impl Mul for $name {
            type Output = Self;
            #[inline]
            fn mul(self, other: Self) -> Self { Self(self.0 * other.0) }
        }
        impl Div for $name {
            type Output = Self;
            #[inline]
            fn div(self, other: Self) -> Self { Self(self.0 / other.0) }
        }
        impl Neg for $name {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self { Self(-self.0) }
        }
        impl Real for $name {
            const FORMULAS: Formulas = Formulas::$formulas;
            const WIDTH: Width = Width::Single;
            const ZERO: Self = Self(0.0);
            const TWO: Self = Self(2.0);
            const MISS: Self = Self(f32::MAX);

            fn from_f64(value: f64) -> Self { Self(value as f32) }
            fn from_u32(value: u32) -> Self { Self(value as f32) }
            fn to_f32(self) -> f32 { self.0 }
            fn to_f64(self) -> f64 { f64::from(self.0) }
            fn sqrt(self) -> Self { Self(self.0.sqrt()) }
            fn abs(self) -> Self { Self(self.0.abs()) }
            fn copysign(self, sign: Self) -> Self { Self(self.0.copysign(sign.0)) }
        }
    )*};
}

single_numbers! {
    /// An f32 of [`Accuracy::Textbook`].
    Textbook Textbook
    /// An f32 of [`Accuracy::Adaptive`].
    Bounded Bounded
}

/// A number of [`Accuracy::Robust`].
pub type Robust = f32;
/// A number of [`Accuracy::Extended`].
pub type Extended = TwoFloat;
/// A number of [`Accuracy::Double`].
pub type Double = f64;

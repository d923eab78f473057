//! The number type of the geometry, which stands for an accuracy tier: how wide numbers
//! are, and which formulas are computed in them.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::tier::{Formulas, Width};

/// A number of an accuracy tier.
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + bytemuck::Pod
    + Send
    + Sync
{
    /// Which formulas are computed in it.
    const FORMULAS: Formulas;
    /// How wide it is.
    const WIDTH: Width;
    /// 0.
    const ZERO: Self;
    /// 2.
    const TWO: Self;
    /// The value of t that stands for "no hit": the largest finite f32 in every width, since
    /// WGSL has no infinity, and t is handed on in parts of f32. What is met beyond, in lengths
    /// of the direction that is traced, is no hit.
    const MISS: Self;

    /// The nearest number of this width.
    fn from_f64(value: f64) -> Self;
    /// The integer as a number of this width; exact below 2^24.
    fn from_u32(value: u32) -> Self;
    /// The nearest f32, in which shading is done and pictures are kept.
    fn to_f32(self) -> f32;
    /// The nearest f64.
    fn to_f64(self) -> f64;
    /// The square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// The absolute value.
    fn abs(self) -> Self;
    /// The magnitude of `self` with the sign of `sign`, and with its sign bit where the
    /// width is that of f32.
    fn copysign(self, sign: Self) -> Self;
}

/// A constant in the width; in WGSL a conversion.
pub fn constant<R: Real>(value: f32) -> R {
    R::from_f64(f64::from(value))
}

impl Real for f32 {
    const FORMULAS: Formulas = Formulas::Stable;
    const WIDTH: Width = Width::Single;
    const ZERO: Self = 0.0;
    const TWO: Self = 2.0;
    const MISS: Self = Self::MAX;

    fn from_f64(value: f64) -> Self {
        value as Self
    }
    fn from_u32(value: u32) -> Self {
        value as Self
    }
    fn to_f32(self) -> f32 {
        self
    }
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    fn abs(self) -> Self {
        Self::abs(self)
    }
    fn copysign(self, sign: Self) -> Self {
        Self::copysign(self, sign)
    }
}

impl Real for f64 {
    const FORMULAS: Formulas = Formulas::Stable;
    const WIDTH: Width = Width::Double;
    const ZERO: Self = 0.0;
    const TWO: Self = 2.0;
    const MISS: Self = f32::MAX as Self;

    fn from_f64(value: f64) -> Self {
        value
    }
    fn from_u32(value: u32) -> Self {
        Self::from(value)
    }
    fn to_f32(self) -> f32 {
        self as f32
    }
    fn to_f64(self) -> f64 {
        self
    }
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    fn abs(self) -> Self {
        Self::abs(self)
    }
    fn copysign(self, sign: Self) -> Self {
        // WGSL shows no bits of an f64: -0 counts as 0.
        if sign < 0.0 { -self.abs() } else { self.abs() }
    }
}

/// The magnitude of `magnitude` with the sign bit of `sign`.
pub fn copy_sign<R: Real>(magnitude: R, sign: R) -> R {
    magnitude.copysign(sign)
}

//! The number type of the geometry: f32 or f64.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A floating-point width that the kernel can be run in.
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
    /// 0.
    const ZERO: Self;
    /// 2.
    const TWO: Self;
    /// The value of t that stands for "no hit": the largest finite number, since
    /// WGSL has no infinity. Every true hit is nearer.
    const MISS: Self;

    /// The nearest number of this width.
    fn from_f64(value: f64) -> Self;
    /// The integer as a number of this width; exact below 2^24.
    fn from_u32(value: u32) -> Self;
    /// The nearest f32, in which shading is done and pictures are kept.
    fn to_f32(self) -> f32;
    /// The square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// The absolute value.
    fn abs(self) -> Self;
    /// The magnitude of `self` with the sign bit of `sign`.
    fn copysign(self, sign: Self) -> Self;
}

macro_rules! impl_real {
    ($t:ty) => {
        impl Real for $t {
            const ZERO: Self = 0.0;
            const TWO: Self = 2.0;
            const MISS: Self = <$t>::MAX;

            fn from_f64(value: f64) -> Self {
                value as $t
            }
            fn from_u32(value: u32) -> Self {
                value as $t
            }
            fn to_f32(self) -> f32 {
                self as f32
            }
            fn sqrt(self) -> Self {
                <$t>::sqrt(self)
            }
            fn abs(self) -> Self {
                <$t>::abs(self)
            }
            fn copysign(self, sign: Self) -> Self {
                <$t>::copysign(self, sign)
            }
        }
    };
}

impl_real!(f32);
impl_real!(f64);

/// The magnitude of `magnitude` with the sign bit of `sign`.
pub fn copy_sign<R: Real>(magnitude: R, sign: R) -> R {
    magnitude.copysign(sign)
}

//! Correctly rounded division and square root, by name.
//!
//! Rust's are correctly rounded already. WGSL promises only 2.5 ulp, so the
//! shaders call these two names, behind which stands the plain operator or a
//! corrected one, as the device's self-check demands.

use super::real::Real;

/// a / b.
pub fn divide<R: Real>(a: R, b: R) -> R {
    a / b
}

/// The square root of a.
pub fn square_root<R: Real>(a: R) -> R {
    a.sqrt()
}

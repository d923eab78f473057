//! What the decisions are computed in: numbers that know how far they may be off.
//!
//! Each formula is written once, over [`Number`], and run in up to three widths: quick,
//! with a bound on its error ([`super::filter`]); with twice the bits and a bound
//! ([`super::double`]); exactly ([`super::exact`]). Only sums and products occur before a
//! decision, so the exact width needs no more than integers.

use std::cmp::Ordering;

/// A number that is known exactly, or to within a bound.
pub trait Number: Clone {
    /// Exactly this number, which is finite.
    fn exact(value: f64) -> Self;
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The difference.
    fn minus(&self, other: &Self) -> Self;
    /// The product.
    fn times(&self, other: &Self) -> Self;
    /// How the number compares with zero, if that is certain.
    fn sign(&self) -> Option<Ordering>;
}

/// A number that can be divided, and whose root can be taken, to within a bound.
pub trait Divide: Number {
    /// The quotient; the divisor is not zero.
    fn over(&self, divisor: &Self) -> Self;
    /// The square root of a number that is not negative.
    fn square_root(&self) -> Self;
}

/// Three numbers.
pub type Vector<N> = [N; 3];

/// Three exact numbers.
#[inline]
pub fn vector<N: Number>(v: [f64; 3]) -> Vector<N> {
    v.map(N::exact)
}

/// a - b.
#[inline]
pub fn difference<N: Number>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    std::array::from_fn(|axis| a[axis].minus(&b[axis]))
}

/// a . b.
#[inline]
pub fn dot<N: Number>(a: &Vector<N>, b: &Vector<N>) -> N {
    let xy = a[0].times(&b[0]).plus(&a[1].times(&b[1]));
    xy.plus(&a[2].times(&b[2]))
}

/// a x b.
#[inline]
pub fn cross<N: Number>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    let component = |i: usize, j: usize| a[i].times(&b[j]).minus(&a[j].times(&b[i]));
    [component(1, 2), component(2, 0), component(0, 1)]
}

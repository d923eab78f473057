//! The two f32 against integers and f64, each test with a control that fails.
//!
//! The numbers tried have their last bit within 53 of their first, so f64 holds each
//! exactly and is off by 2^-53 at most after one operation.

use super::*;
use crate::random::Numbers;

/// Bound of the tests; the algorithms' own lie at 3, 5, 15 and 25/8 of 2^-48.
const MOST: f64 = 1.0 / (1_u64 << 44) as f64;

const TRIES: u32 = 200_000;

struct Random(Numbers);

impl Random {
    fn below(&mut self, end: u32) -> u32 {
        (self.0.next() >> 33) as u32 % end
    }

    /// A pair of either sign, of 2^-span to 2^span; every eighth has no low part, and
    /// others a low part up to 2^5 smaller than it might be.
    fn pair(&mut self, span: u32) -> TwoFloat {
        let high = i64::from(self.below(1 << 23) + (1 << 23));
        let low = i64::from(self.below(1 << 24)) - (1 << 23);
        let gap = self.below(6);
        let low = if self.below(8) == 0 { 0 } else { low };
        let sign = if self.below(2) == 0 { 1 } else { -1 };
        let digits = sign * ((high << (24 + gap)) + low);
        let exponent = self.below(2 * span) as i32 - span as i32 - 48 - gap as i32;
        TwoFloat::from_f64(digits as f64 * 2.0_f64.powi(exponent))
    }
}

fn exact(a: TwoFloat) -> f64 {
    f64::from(a.high) + f64::from(a.low)
}

fn is_normal(a: TwoFloat) -> bool {
    a.high + a.low == a.high
}

/// What two f32 make of two numbers, and what f64 makes of them.
type Operation = (fn(TwoFloat, TwoFloat) -> TwoFloat, fn(f64, f64) -> f64);

/// The largest relative error over pairs of 2^-span to 2^span; every other pair of
/// like size, so that differences cancel.
fn worst_error((two, wide): Operation, span: u32) -> f64 {
    let mut random = Random(Numbers(u64::from(span)));
    let mut worst: f64 = 0.0;
    for index in 0..TRIES {
        let a = random.pair(span);
        let mut b = random.pair(span);
        if index % 2 == 0 {
            let near = 1.0 + f64::from(random.below(1 << 20)) * 2.0_f64.powi(-47);
            let digits = (exact(a) / near).to_bits() & !0x1f;
            b = TwoFloat::from_f64(-f64::from_bits(digits));
        }
        let expected = wide(exact(a), exact(b));
        let found = two(a, b);
        assert!(is_normal(found), "{found:?} of {a:?} and {b:?}");
        if expected == 0.0 {
            assert_eq!(exact(found), 0.0, "of {a:?} and {b:?}");
        } else {
            worst = worst.max(((exact(found) - expected) / expected).abs());
        }
    }
    println!("worst error: 2^{:.2}", worst.log2());
    worst
}

#[test]
fn sums_keep_their_relative_error_even_where_they_cancel() {
    assert!(worst_error((add_two, |a, b| a + b), 20) < MOST);
    assert!(worst_error((subtract_two, |a, b| a - b), 20) < MOST);
    // The control: algorithm 5, SloppyDWPlusDW, adds the low parts in f32.
    let sloppy = |a: TwoFloat, b: TwoFloat| {
        let sum = two_sum(a.high, b.high);
        quick_two_sum(sum.high, sum.low + (a.low + b.low))
    };
    assert!(worst_error((sloppy, |a, b| a + b), 20) > MOST);
}

#[test]
fn products_keep_their_relative_error() {
    for span in [2, 30] {
        assert!(worst_error((multiply_two, |a, b| a * b), span) < MOST);
        let scaled: Operation = (|a, b| scale_two(a, b.high), |a, b| a * f64::from(b as f32));
        assert!(worst_error(scaled, span) < MOST);
    }
    // The control: a product whose error is left out.
    let sloppy =
        |a: TwoFloat, b: TwoFloat| quick_two_sum(a.high * b.high, a.high * b.low + a.low * b.high);
    assert!(worst_error((sloppy, |a, b| a * b), 30) > MOST);
}

#[test]
fn quotients_keep_their_relative_error() {
    for span in [2, 30] {
        assert!(worst_error((divide_two, |a, b| a / b), span) < MOST);
    }
    // The control: no second step.
    let sloppy = |a: TwoFloat, b: TwoFloat| TwoFloat {
        high: a.high / b.high,
        low: 0.0,
    };
    assert!(worst_error((sloppy, |a, b| a / b), 30) > MOST);
}

#[test]
fn roots_keep_their_relative_error() {
    for span in [2, 60] {
        let root: Operation = (
            |a, _| square_root_two(absolute_two(a)),
            |a, _| a.abs().sqrt(),
        );
        assert!(worst_error(root, span) < MOST);
    }
    let sloppy: Operation = (
        |a, _| TwoFloat {
            high: a.high.abs().sqrt(),
            low: 0.0,
        },
        |a, _| a.abs().sqrt(),
    );
    assert!(worst_error(sloppy, 60) > MOST, "the control");
}

/// Against integers: f32 that are whole numbers below 2^62.
#[test]
fn sums_and_products_of_f32_are_exact() {
    let mut random = Random(Numbers(1));
    let mut quick_failed = 0;
    for _ in 0..TRIES {
        let whole = |random: &mut Random| {
            let digits = random.below(1 << 25) as f32 - 16_777_216.0;
            digits * 2.0_f32.powi(random.below(38) as i32)
        };
        let (a, b) = (whole(&mut random), whole(&mut random));
        let integer = |two: TwoFloat| two.high as i128 + two.low as i128;
        let sum = a as i128 + b as i128;
        assert_eq!(integer(two_sum(a, b)), sum, "{a} + {b}");
        let (larger, smaller) = if a.abs() < b.abs() { (b, a) } else { (a, b) };
        assert_eq!(integer(quick_two_sum(larger, smaller)), sum, "{a} + {b}");
        quick_failed += usize::from(integer(quick_two_sum(smaller, larger)) != sum);
        // In f64 the product has all its 48 bits, and so have its parts.
        let product = two_product(a, b);
        assert_eq!(exact(product), f64::from(a) * f64::from(b), "{a} * {b}");
        assert_eq!(product, two_product(b, a));
    }
    assert!(quick_failed > 0, "the control: the smaller one first");
}

#[test]
fn products_do_not_depend_on_the_order() {
    let mut random = Random(Numbers(2));
    let mut scaled_differ = 0;
    for _ in 0..TRIES {
        let (a, b) = (random.pair(30), random.pair(30));
        assert_eq!(a * b, b * a);
        assert_eq!(a + b, b + a);
        scaled_differ += usize::from(scale_two(a, b.high) != scale_two(b, a.high));
    }
    assert!(scaled_differ > 0, "the control: one low part left out");
}

#[test]
fn integers_are_exact() {
    let mut random = Random(Numbers(3));
    let mut rounded = 0;
    let chosen = [0, 1, 0xffff, 0x1_0000, 0x1_0001, u32::MAX];
    let any = (0..TRIES).map(|_| random.0.next() as u32);
    for value in chosen.into_iter().chain(any) {
        let two = TwoFloat::from_u32(value);
        assert!(is_normal(two) && exact(two) == f64::from(value), "{value}");
        assert_eq!(two, TwoFloat::from_f64(f64::from(value)));
        rounded += usize::from(two.low != 0.0);
    }
    assert!(rounded > 0, "the control: f32 alone holds not all");
}

#[test]
fn comparisons_are_those_of_the_values() {
    let mut random = Random(Numbers(4));
    let mut by_low_part = 0;
    for index in 0..TRIES {
        let a = random.pair(30);
        let mut b = random.pair(30);
        match index % 3 {
            0 => b = a,
            1 => b = TwoFloat::from_f64(exact(a) * (1.0 - 2.0_f64.powi(-40))),
            _ => {}
        }
        let (x, y) = (exact(a), exact(b));
        assert_eq!(a.partial_cmp(&b), x.partial_cmp(&y));
        assert_eq!(
            (a < b, a <= b, a > b, a >= b),
            (x < y, x <= y, x > y, x >= y)
        );
        assert_eq!((a == b, equal_two(a, b)), (x == y, x == y));
        assert_eq!(exact(least_two(a, b)), x.min(y));
        assert_eq!(exact(greatest_two(a, b)), x.max(y));
        assert_eq!(exact(a.abs()), x.abs());
        assert_eq!(exact(a.copysign(b)), x.copysign(y));
        by_low_part += usize::from(a.high == b.high && a != b);
    }
    assert!(by_low_part > 0, "the control: the high parts tell not all");
    let nan = TwoFloat::from_f64(f64::NAN);
    let any = [nan < nan, nan <= nan, nan > nan, nan >= nan, nan == nan];
    assert_eq!(any, [false; 5]);
}

#[test]
fn zeros_make_no_nan() {
    let (zero, one) = (TwoFloat::ZERO, TwoFloat::from_u32(1));
    for result in [zero / one, zero.sqrt(), zero * one, one - one, zero + zero] {
        assert_eq!(result, zero);
    }
    let quotient = one / zero;
    assert_eq!(quotient.partial_cmp(&zero), None, "the control");
}

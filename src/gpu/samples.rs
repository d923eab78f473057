//! Numbers on which a device's arithmetic is tried.
//!
//! A nearly correct division or root rounds the wrong way only where the result
//! lies next to the middle between two f32, which chance does not find.

/// The bits of a significand, the leading one included.
const DIGITS: u32 = 24;

/// The significands from here to twice as much have all their bits.
const LEADING_ONE: u32 = 1 << (DIGITS - 1);

/// Jarzynski, Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020: pcg.
pub(super) fn hash(value: u32) -> u32 {
    let state = value.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// The number with the sign and the fraction of `bits`.
pub(super) fn number(bits: u32, exponent: u32) -> f32 {
    f32::from_bits((bits & 0x807f_ffff) | (exponent << 23))
}

/// A dividend and a divisor of any exponents whose quotient is a normal number:
/// a reciprocal of the largest divisors is not, and a device may flush it.
pub(super) fn any_normal_quotient(a: u32, b: u32, choice: u32) -> (f32, f32) {
    // Stored exponents of normal numbers are 1 to 254, that of 1 is 127.
    let dividend = 1 + choice % 254;
    let least = dividend.saturating_sub(127).max(1);
    let largest = (dividend + 125).min(254);
    let divisor = least + (choice >> 16) % (largest - least + 1);
    (number(a, dividend), number(b, divisor))
}

/// A dividend and a divisor whose quotient is as near to the middle between two
/// f32 as one can be, at most 2^-24 of their distance.
///
/// `seed` chooses the divisor.
pub(super) fn quotient_near_midpoint(seed: u32) -> (f32, f32) {
    let b = LEADING_ONE | (seed % LEADING_ONE) | 1;
    // a = 2^-25 modulo b. So 2^25 a / b, twice a 24-bit quotient, is 1 / b beside
    // an integer; the integer is odd, for its product with b is 2^25 a +- 1.
    let a = (0..=DIGITS).fold(1, |a, _| if a % 2 == 0 { a / 2 } else { (a + b) / 2 });
    // -a serves as well; the larger one has a quotient above 1/2.
    (a.max(b - a) as f32, b as f32)
}

/// A number whose root lies at most |`seed`| + 1 times 2^-23 of the distance of
/// two f32 from the middle between them.
pub(super) fn root_near_midpoint(seed: i32) -> f32 {
    // Sought is a 24-bit r with r^2 + r + offset = 2^24 a, for the middle is at
    // r^2 + r + 1/4. So (2 r + 1)^2 = 1 - 4 offset modulo 2^26, which an odd number
    // solves, lifted bit by bit (Hensel), for the right side is 1 modulo 8.
    let offset = 2 * i64::from(seed);
    let target = 1 - 4 * offset;
    let root = (2..=DIGITS).fold(1_i64, |root, bit| {
        let solved = (root * root - target) % (1 << (bit + 2)) == 0;
        if solved { root } else { root + (1 << bit) }
    });
    // -root solves it too; one of both gives 24 bits.
    let r = (root - 1) / 2;
    let r = r.max((1 << DIGITS) - 1 - r);
    ((r * r + r + offset) >> DIGITS) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_quotient_is_nearer_to_a_midpoint() {
        for seed in 0..10_000_u32 {
            let (a, b) = quotient_near_midpoint(seed.wrapping_mul(0x9e37_79b9));
            assert!(a < b && b < 2.0 * a && b < 16_777_216.0, "{a} / {b}");
            let (a, b) = (a as i64, b as i64);
            let doubled = ((a << 25) / b) | 1;
            assert_eq!((doubled * b).abs_diff(a << 25), 1, "{a} / {b}");
        }
    }

    #[test]
    fn roots_are_next_to_a_midpoint() {
        for seed in -10_000..10_000 {
            let a = root_near_midpoint(seed);
            assert!(a < 16_777_216.0, "the root of {a}");
            // The root in units of the last of 24 bits: 2^12 times it, in f64,
            // whose own error is far below the distance from the middle.
            let root = f64::from(a).sqrt() * 4096.0;
            assert!(
                (8_388_608.0..16_777_216.0).contains(&root),
                "the root of {a}"
            );
            let distance = (root.fract() - 0.5).abs();
            let bound = f64::from(seed.abs() + 1) / f64::from(1 << 23);
            assert!(
                distance <= bound && distance > 0.0,
                "{distance}: the root of {a}"
            );
        }
    }
}

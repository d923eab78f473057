//! Powers of e and natural logarithms, without a device's own, of which no two agree.

/// The logarithm of 2: a first part of 16 bits, so that its product with an exponent is
/// exact, and the rest.
const LOG_TWO: [f32; 2] = [0.69314575, 1.4286068e-06];

/// 1 over the logarithm of 2.
const LOG_TWO_INVERSE: f32 = std::f32::consts::LOG2_E;

/// Below, e^x counts as 0. Here it is 1.4 times the least normal number.
const LEAST_POWER: f32 = -87.0;

/// (e^x - 1 - x) / x^2 as a polynomial that is off by 3.2e-9 of e^x where |x| is at most half
/// of the logarithm of 2 (Remez).
const POWER: [f32; 5] = [
    0.49999994,
    0.16666517,
    0.041668102,
    0.0083691925,
    0.0013838867,
];

/// (log(1 + x) - x + x^2 / 2) / x^3, likewise, off by 6.4e-9 of the logarithm, where 1 + x is
/// from the root of 1/2 to that of 2.
const LOGARITHM: [f32; 8] = [
    0.3333333,
    -0.2500082,
    0.20001231,
    -0.16623403,
    0.14201717,
    -0.13159756,
    0.12761621,
    -0.07635545,
];

/// The bits of the root of 1/2.
const ROOT_OF_HALF: i32 = 0x3f35_04f3;

/// e^x of an `x` of 0 or less, off by 2^-23 of it at most; of 0 it is 1, and below -87 it is 0.
///
/// A power of 2 is taken away, so that the rest is in reach of a polynomial: Muller,
/// "Elementary Functions", 3rd edition, 2016, 11.1.
pub fn exponential(x: f32) -> f32 {
    if x < LEAST_POWER {
        return 0.0;
    }
    let exponent = (x * LOG_TWO_INVERSE + 0.5).floor();
    let rest = (x - exponent * LOG_TWO[0]) - exponent * LOG_TWO[1];
    let high = POWER[2] + rest * (POWER[3] + rest * POWER[4]);
    let sum = POWER[0] + rest * (POWER[1] + rest * high);
    let power = 1.0 + (rest + (rest * rest) * sum);
    let scale = f32::from_bits(((exponent as i32 + 127) as u32) << 23);
    power * scale
}

/// The natural logarithm of a positive, normal `x`, off by 2^-22 of it at most; of 1 it is 0.
pub fn logarithm(x: f32) -> f32 {
    let bits = x.to_bits() as i32;
    let exponent = (bits - ROOT_OF_HALF) >> 23;
    let rest = f32::from_bits((bits - (exponent << 23)) as u32) - 1.0;
    let high = LOGARITHM[6] + rest * LOGARITHM[7];
    let middle = LOGARITHM[3] + rest * (LOGARITHM[4] + rest * (LOGARITHM[5] + rest * high));
    let sum = LOGARITHM[0] + rest * (LOGARITHM[1] + rest * (LOGARITHM[2] + rest * middle));
    let curved = (rest * rest) * (rest * sum - 0.5);
    let twos = exponent as f32;
    twos * LOG_TWO[0] + (rest + (curved + twos * LOG_TWO[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn relative(found: f32, expected: f64) -> f64 {
        if expected == 0.0 {
            return f64::from(found.abs());
        }
        ((f64::from(found) - expected) / expected).abs()
    }

    /// The largest relative error of `found` over these.
    fn worst(
        inputs: impl Iterator<Item = f32>,
        found: impl Fn(f32) -> f32,
        expected: impl Fn(f64) -> f64,
    ) -> f64 {
        inputs.fold(0.0, |worst: f64, x| {
            worst.max(relative(found(x), expected(f64::from(x))))
        })
    }

    /// From 0 to the least power, all magnitudes alike.
    fn powers() -> impl Iterator<Item = f32> {
        let least = LEAST_POWER.to_bits();
        ((-0f32).to_bits()..=least).step_by(487).map(f32::from_bits)
    }

    /// All magnitudes alike, and all those next to 1.
    fn normals() -> impl Iterator<Item = f32> {
        let one = 1f32.to_bits();
        let all = (f32::MIN_POSITIVE.to_bits()..=f32::MAX.to_bits()).step_by(997);
        all.chain(one - 200_000..one + 200_000).map(f32::from_bits)
    }

    #[test]
    fn powers_are_near() {
        let found = worst(powers(), exponential, f64::exp);
        println!("worst error: {found:e}");
        // The last sum and the polynomial's, of up to 1.42 times the ulp; the power of 2 is
        // exact.
        assert!(found < 1.0 / (1 << 23) as f64, "{found:e}");
        // The control: the logarithm of 2 in one part.
        let plain = |x: f32| {
            let exponent = (x * LOG_TWO_INVERSE + 0.5).floor();
            let rest = x - exponent * std::f32::consts::LN_2;
            rest.exp() * exponent.exp2()
        };
        assert!(worst(powers(), plain, f64::exp) > 1e-6);
    }

    #[test]
    fn powers_end_at_one_and_at_zero() {
        assert_eq!([0.0, -0.0, -1e-30].map(exponential), [1.0; 3]);
        let least = exponential(LEAST_POWER);
        assert!((f32::MIN_POSITIVE..2e-38).contains(&least), "{least:e}");
        let below = [LEAST_POWER.next_down(), -1e10, f32::MIN, f32::NEG_INFINITY];
        assert_eq!(below.map(exponential), [0.0; 4]);
        assert!(powers().all(|x| (0.0..=1.0).contains(&exponential(x))));
    }

    #[test]
    fn logarithms_are_near() {
        let found = worst(normals(), logarithm, f64::ln);
        println!("worst error: {found:e}");
        assert!(found < 1.0 / (1 << 22) as f64, "{found:e}");
        assert_eq!(logarithm(1.0).to_bits(), 0);
        // The control: the exponent as it is stored, so that just below 1 two terms cancel.
        let plain = |x: f32| {
            let exponent = (x.to_bits() >> 23) as f32 - 127.0;
            let rest = f32::from_bits(x.to_bits() & 0x7f_ffff | 0x3f80_0000);
            exponent * std::f32::consts::LN_2 + rest.ln()
        };
        assert!(worst(normals(), plain, f64::ln) > 1e-5);
    }

    #[test]
    fn one_undoes_the_other() {
        for x in powers().filter(|x| *x < -1e-3) {
            let back = logarithm(exponential(x));
            // An error of a power is one of as much in its logarithm.
            let most = 2.0 * f32::EPSILON * (1.0 + x.abs());
            assert!((back - x).abs() < most, "{x}: {back}");
        }
    }
}

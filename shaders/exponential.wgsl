// Powers of e and natural logarithms, without a device's own, of which no two agree.

// The logarithm of 2: a first part of 16 bits, so that its product with an exponent is
// exact, and the rest.
const LOG_TWO: vec2<f32> = vec2<f32>(0.69314575, 1.4286068e-06);

// 1 over the logarithm of 2.
const LOG_TWO_INVERSE: f32 = 1.442695;

// Below, e^x counts as 0. Here it is 1.4 times the least normal number.
const LEAST_POWER: f32 = -87.0;

// (e^x - 1 - x) / x^2 as a polynomial that is off by 3.2e-9 of e^x where |x| is at most half
// of the logarithm of 2 (Remez).
const POWER: array<f32, 5> = array<f32, 5>(
    0.49999994,
    0.16666517,
    0.041668102,
    0.0083691925,
    0.0013838867,
);

// (log(1 + x) - x + x^2 / 2) / x^3, likewise, off by 6.4e-9 of the logarithm, where 1 + x is
// from the root of 1/2 to that of 2.
const LOGARITHM: array<f32, 8> = array<f32, 8>(
    0.3333333,
    -0.2500082,
    0.20001231,
    -0.16623403,
    0.14201717,
    -0.13159756,
    0.12761621,
    -0.07635545,
);

// The bits of the root of 1/2.
const ROOT_OF_HALF: i32 = 0x3f3504f3;

// e^x of an `x` of 0 or less, off by 2^-23 of it at most; of 0 it is 1, and below -87 it is 0.
//
// A power of 2 is taken away, so that the rest is in reach of a polynomial: Muller,
// "Elementary Functions", 3rd edition, 2016, 11.1.
fn exponential(x: f32) -> f32 {
    if x < LEAST_POWER {
        return 0.0;
    }
    let exponent = floor(x * LOG_TWO_INVERSE + 0.5);
    let rest = (x - exponent * LOG_TWO.x) - exponent * LOG_TWO.y;
    let high = POWER[2] + rest * (POWER[3] + rest * POWER[4]);
    let sum = POWER[0] + rest * (POWER[1] + rest * high);
    let power = 1.0 + (rest + (rest * rest) * sum);
    let scale = bitcast<f32>(u32(i32(exponent) + 127) << 23u);
    return power * scale;
}

// The natural logarithm of a positive, normal `x`, off by 2^-22 of it at most; of 1 it is 0.
fn logarithm(x: f32) -> f32 {
    let bits = bitcast<i32>(x);
    let exponent = (bits - ROOT_OF_HALF) >> 23u;
    let rest = bitcast<f32>(bits - (exponent << 23u)) - 1.0;
    let high = LOGARITHM[6] + rest * LOGARITHM[7];
    let middle = LOGARITHM[3] + rest * (LOGARITHM[4] + rest * (LOGARITHM[5] + rest * high));
    let sum = LOGARITHM[0] + rest * (LOGARITHM[1] + rest * (LOGARITHM[2] + rest * middle));
    let curved = (rest * rest) * (rest * sum - 0.5);
    let twos = f32(exponent);
    return twos * LOG_TWO.x + (rest + (curved + twos * LOG_TWO.y));
}

// Division and square root with IEEE 754's bits, on a device that rounds them
// loosely: f32, round to nearest, ties to even.
//
// The device's own operators only estimate the result's 24 bits; integers put
// the estimate right. The remainder that decides is exact in its low 32 bits,
// and it has no more than those where the device is at most 30 ulp off; Vulkan
// allows 2.5 for `/`. So no float operation has to be exact here, a contracted
// one does no harm, and zeros, denormal numbers, infinities and NaN, which a
// device may flush or assume away, meet none.

const SIGN_BIT: u32 = 0x80000000u;
const INFINITY_BITS: u32 = 0x7f800000u;
const NAN_BITS: u32 = 0x7fc00000u;

// The bits of a significand after its leading one.
const FRACTION_BITS: u32 = 23u;
const LEADING_ONE: i32 = 0x800000;

// The largest exponent of a finite number, as it is stored.
const LARGEST_EXPONENT: i32 = 254;

// What is stored as the exponent of 1.
const EXPONENT_BIAS: i32 = 127;

// The positive number significand * 2^(exponent - 150).
struct Unpacked {
    // As stored in a normal number; 0 or less for a denormal one.
    exponent: i32,
    // From 2^23 up to 2^24 - 1.
    significand: i32,
}

fn native_quotient(a: f32, b: f32) -> f32 {
    return a / b;
}

fn native_root(a: f32) -> f32 {
    return sqrt(a);
}

// a / b.
fn divide(a: real, b: real) -> real {
    let sign = (bitcast<u32>(a) ^ bitcast<u32>(b)) & SIGN_BIT;
    let a_bits = bitcast<u32>(a) & ~SIGN_BIT;
    let b_bits = bitcast<u32>(b) & ~SIGN_BIT;
    if is_zero_or_not_finite(a_bits) || is_zero_or_not_finite(b_bits) {
        return bitcast<real>(sign | special_quotient(a_bits, b_bits));
    }
    let dividend = unpack(a_bits);
    let divisor = unpack(b_bits);
    return bitcast<real>(sign | finite_quotient(dividend, divisor));
}

// The square root of a.
fn square_root(a: real) -> real {
    let bits = bitcast<u32>(a);
    if (bits & ~SIGN_BIT) == 0u || bits == INFINITY_BITS {
        return a;
    }
    if bits > INFINITY_BITS {
        // A NaN, or less than zero.
        return bitcast<real>(bits | NAN_BITS);
    }
    return bitcast<real>(finite_root(unpack(bits)));
}

fn is_zero_or_not_finite(magnitude: u32) -> bool {
    return magnitude == 0u || magnitude >= INFINITY_BITS;
}

// The magnitude of a / b where one of them is zero, infinite or NaN.
fn special_quotient(a: u32, b: u32) -> u32 {
    if a > INFINITY_BITS || b > INFINITY_BITS || a == b {
        return NAN_BITS;
    }
    return select(0u, INFINITY_BITS, a == INFINITY_BITS || b == 0u);
}

fn unpack(magnitude: u32) -> Unpacked {
    let exponent = i32(magnitude >> FRACTION_BITS);
    if exponent == 0 {
        let shift = countLeadingZeros(magnitude) - countLeadingZeros(u32(LEADING_ONE));
        return Unpacked(1 - i32(shift), i32(magnitude << shift));
    }
    return Unpacked(exponent, (i32(magnitude) & (LEADING_ONE - 1)) | LEADING_ONE);
}

// Let a and b be the significands, a doubled if it is the smaller one. What is
// sought is the integer q nearest to 2^23 a / b, which then has 24 bits.
// - Never does 2^23 a / b lie midway between two integers: as an odd multiple of
//   1/2 it has 25 significant bits, so its product with b has, but a has 24.
// - Where the estimate is k off, the remainder 2^23 a - q b is k b, below 2^31 up
//   to k = 128. An error of 30 ulp in 1 / b is one of 60 to 120 in q, as ulp is
//   taken below or above a power of two; product and conversion add less than 2.
// - The step, itself estimated, misses by one at most; the last comparison tells.
fn finite_quotient(dividend: Unpacked, divisor: Unpacked) -> u32 {
    let b = divisor.significand;
    let smaller = dividend.significand < b;
    let a = select(dividend.significand, 2 * dividend.significand, smaller);
    let exponent =
        dividend.exponent - divisor.exponent + select(EXPONENT_BIAS, EXPONENT_BIAS - 1, smaller);

    let reciprocal = native_quotient(1.0, f32(b));
    var quotient = i32(f32(a) * reciprocal * f32(LEADING_ONE));
    var remainder = (a << FRACTION_BITS) - quotient * b;
    let step = i32(round(f32(remainder) * reciprocal));
    quotient += step;
    remainder -= step * b;
    let unit = select(0, 1, 2 * remainder > b) - select(0, 1, 2 * remainder < -b);
    quotient += unit;
    remainder -= unit * b;

    if exponent > LARGEST_EXPONENT {
        return INFINITY_BITS;
    }
    if exponent < 1 {
        return denormal_quotient(u32(1 - exponent), quotient, remainder);
    }
    // The leading one adds the last unit of the exponent.
    return (u32(exponent - 1) << FRACTION_BITS) + u32(quotient);
}

// A quotient that loses its last `lost` bits, one at least. The remainder's sign
// tells a tie from its neighbours.
fn denormal_quotient(lost: u32, quotient: i32, remainder: i32) -> u32 {
    let exact = u32(4 * quotient + sign(remainder));
    // Less than half of the smallest number is left when 25 bits are lost.
    let shift = min(lost, 25u) + 2u;
    let kept = exact >> shift;
    let rest = exact - (kept << shift);
    let half = 1u << (shift - 1u);
    let up = rest > half || (rest == half && (kept & 1u) == 1u);
    return kept + select(0u, 1u, up);
}

// Let a be the significand, doubled if the stored exponent is even, so that an
// even power of two remains beside 2^23 a. What is sought is the integer r nearest
// to the root of 2^23 a, which has 24 bits.
// - No root lies midway: (r + 1/2)^2 = r^2 + r + 1/4 is not an integer. So it is
//   r unless the remainder 2^23 a - r^2 is above r or not above -r.
// - Where the estimate is k off, the remainder is at most k (2^25 + k), below 2^31
//   up to k = 63. An error of 30 ulp is one of 30 to 60; the conversion adds 1.
// - The step leaves out k^2 / 2 r, which is below 2^-12, and is estimated; it
//   misses by one at most.
fn finite_root(square: Unpacked) -> u32 {
    let even = (square.exponent & 1) == 0;
    let a = select(square.significand, 2 * square.significand, even);
    let exponent = (square.exponent + select(EXPONENT_BIAS, EXPONENT_BIAS - 1, even)) >> 1u;

    var root = i32(native_root(f32(a) * f32(LEADING_ONE)));
    let first = (a << FRACTION_BITS) - root * root;
    root += i32(round(native_quotient(f32(first), 2.0 * f32(root))));
    let remainder = (a << FRACTION_BITS) - root * root;
    root += select(0, 1, remainder > root) - select(0, 1, remainder <= -root);
    return (u32(exponent - 1) << FRACTION_BITS) + u32(root);
}

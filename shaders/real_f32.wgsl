// The number type of the geometry: f32.

alias real = f32;

// The value of t that stands for "no hit": the largest finite number.
const MISS: real = 3.4028234663852886e38;

// The magnitude of `magnitude` with the sign bit of `sign`.
fn copy_sign(magnitude: real, sign: real) -> real {
    let bits = (bitcast<u32>(magnitude) & 0x7fffffffu) | (bitcast<u32>(sign) & 0x80000000u);
    return bitcast<real>(bits);
}

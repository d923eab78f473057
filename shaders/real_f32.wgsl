// The number type of the geometry: f32.

alias real = f32;

// The value of t that stands for "no hit": the largest finite number.
const MISS: real = 3.4028234663852886e38;

// How many f32 a number is read from.
const PARTS: u32 = 1u;

// Four numbers of their parts.
fn reals_of(parts: array<vec4<f32>, PARTS>) -> vec4<real> {
    return parts[0];
}

// Quad `index` of a table, as numbers of the geometry's width.
fn reals_at(table: u32, index: u32) -> vec4<real> {
    return floats_at(table, index);
}

// The magnitude of `magnitude` with the sign bit of `sign`.
fn copy_sign(magnitude: real, sign: real) -> real {
    let bits = (bitcast<u32>(magnitude) & 0x7fffffffu) | (bitcast<u32>(sign) & 0x80000000u);
    return bitcast<real>(bits);
}

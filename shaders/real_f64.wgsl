// The number type of the geometry: f64.

alias real = f64;

// The value of t that stands for "no hit": the largest number of f32, in which t is handed on.
const MISS: real = 3.4028234663852886e38;

// How many f32 a number is read from: WGSL makes no f64 of bits. The sum of three is
// exact.
const PARTS: u32 = 3u;

// Four numbers of their parts.
fn reals_of(parts: array<vec4<f32>, PARTS>) -> vec4<real> {
    return (vec4<real>(parts[0]) + vec4<real>(parts[1])) + vec4<real>(parts[2]);
}

// Quad `index` of a table, as numbers of the geometry's width.
fn reals_at(table: u32, index: u32) -> vec4<real> {
    let first = PARTS * index;
    return reals_of(array<vec4<f32>, PARTS>(
        floats_at(table, first),
        floats_at(table, first + 1u),
        floats_at(table, first + 2u),
    ));
}

// The f32 whose sum a number is.
fn parts_of(number: real) -> vec3<f32> {
    let first = f32(number);
    let rest = number - real(first);
    let second = f32(rest);
    return vec3<f32>(first, second, f32(rest - real(second)));
}

// The magnitude of `magnitude` with the sign of `sign`; WGSL shows no bits of an f64.
fn copy_sign(magnitude: real, sign: real) -> real {
    return select(abs(magnitude), -abs(magnitude), sign < 0.0);
}

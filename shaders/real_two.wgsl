// The number type of the geometry: two f32. It is written as f64, and src/gpu/split.rs
// makes two f32 of each.

alias real = f64;

// The value of t that stands for "no hit": the largest finite number, in two f32 as well.
const MISS: real = 3.4028234663852886e38;

// How many f32 a number is read from.
const PARTS: u32 = 2u;

// The number high + low; in two f32 its parts as they are.
fn real_of_parts(high: f32, low: f32) -> real {
    return real(high) + real(low);
}

// The two f32 of a number; in two f32 its parts as they are.
fn parts_of_real(number: real) -> vec2<f32> {
    let high = f32(number);
    return vec2<f32>(high, f32(number - real(high)));
}

// Four numbers of their parts.
fn reals_of(parts: array<vec4<f32>, PARTS>) -> vec4<real> {
    return vec4<real>(
        real_of_parts(parts[0].x, parts[1].x),
        real_of_parts(parts[0].y, parts[1].y),
        real_of_parts(parts[0].z, parts[1].z),
        real_of_parts(parts[0].w, parts[1].w),
    );
}

// Quad `index` of a table, as numbers of the geometry's width.
fn reals_at(table: u32, index: u32) -> vec4<real> {
    let first = PARTS * index;
    return reals_of(array<vec4<f32>, PARTS>(
        floats_at(table, first),
        floats_at(table, first + 1u),
    ));
}

// The f32 whose sum a number is.
fn parts_of(number: real) -> vec3<f32> {
    let parts = parts_of_real(number);
    return vec3<f32>(parts.x, parts.y, 0.0);
}

// The magnitude of `magnitude` with the sign of `sign`.
fn copy_sign(magnitude: real, sign: real) -> real {
    return select(abs(magnitude), -abs(magnitude), sign < 0.0);
}

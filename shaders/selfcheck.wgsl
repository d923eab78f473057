// What the device's arithmetic does, measured on inputs that the host chose.

struct Probe {
    // The error term of TwoSum(a, b).
    two_sum: f32,
    // The error term of TwoProd(a, b), by splitting.
    two_prod: f32,
    // a * b - p, where p is a * b rounded: 0 unless contracted.
    contraction: f32,
    // fma(a, b, -p): the product's error if fused, 0 if not.
    fused: f32,
    quotient: f32,
    root: f32,
    // a scaled down to where only denormal numbers are left.
    tiny: f32,
    // 1 where a NaN is told from itself, as IEEE 754 demands.
    nan_unequal: u32,
}

struct Input {
    a: f32,
    b: f32,
    dividend: f32,
    divisor: f32,
    radicand: f32,
    // A factor that takes a into the denormal range.
    shrink: f32,
    // A NaN.
    nan: f32,
}

@group(0) @binding(0) var<storage, read> inputs: array<Input>;
@group(0) @binding(1) var<storage, read_write> probes: array<Probe>;
@group(0) @binding(2) var<storage, read_write> loops: array<u32>;

// Knuth, The Art of Computer Programming 2, 4.2.2, theorem B.
fn two_sum_error(a: f32, b: f32) -> f32 {
    let sum = a + b;
    let part = sum - a;
    return (a - (sum - part)) + (b - part);
}

// The upper 12 bits of the mantissa.
fn upper_half(a: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a) & 0xfffff000u);
}

// Dekker, "A floating-point technique for extending the available precision",
// Numerische Mathematik 18, 1971; with the split by a mask.
fn two_prod_error(a: f32, b: f32) -> f32 {
    let product = a * b;
    let a_high = upper_half(a);
    let a_low = a - a_high;
    let b_high = upper_half(b);
    let b_low = b - b_high;
    return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

@compute @workgroup_size(64)
fn measure(@builtin(global_invocation_id) at: vec3<u32>) {
    if at.x >= arrayLength(&inputs) {
        return;
    }
    let input = inputs[at.x];
    let product = input.a * input.b;
    probes[at.x] = Probe(
        two_sum_error(input.a, input.b),
        two_prod_error(input.a, input.b),
        input.a * input.b - product,
        fma(input.a, input.b, -product),
        divide(input.dividend, input.divisor),
        square_root(input.radicand),
        input.a * input.shrink,
        select(0u, 1u, input.nan != input.nan),
    );
}

// Counts to loops[0]; a driver that stops a loop early leaves less in loops[1].
// The running state keeps the driver from computing the count without looping.
@compute @workgroup_size(1)
fn count_loops() {
    var count = 0u;
    var state = loops[2];
    for (var i = 0u; i < loops[0]; i++) {
        state = (state ^ (state << 13u)) + i;
        count++;
    }
    loops[1] = count;
    loops[2] = state;
}

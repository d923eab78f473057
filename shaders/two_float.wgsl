// Arithmetic in two f32: a number is the unevaluated sum of x, the high one, and of y,
// what x lacks. Some 48 bits, on devices without f64. Sources and bounds of the errors
// stand in src/kernel/two_float.rs.

// a + b and its error, exactly, where a is 0 or its exponent is at least b's.
fn quick_two_sum(a: f32, b: f32) -> vec2<f32> {
    let high = a + b;
    let low = b - (high - a);
    return vec2<f32>(high, low);
}

// a + b and its error, exactly.
fn two_sum(a: f32, b: f32) -> vec2<f32> {
    let high = a + b;
    let part = high - a;
    let low = (a - (high - part)) + (b - part);
    return vec2<f32>(high, low);
}

// The upper 12 bits of the mantissa; 12 are left for the rest.
fn upper_half(a: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a) & 0xfffff000u);
}

// a b and its error, exactly.
fn two_product(a: f32, b: f32) -> vec2<f32> {
    let high = a * b;
    let a_high = upper_half(a);
    let a_low = a - a_high;
    let b_high = upper_half(b);
    let b_low = b - b_high;
    let low = ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low;
    return vec2<f32>(high, low);
}

// The integer, exactly: each half of it has 16 bits.
fn two_from_u32(value: u32) -> vec2<f32> {
    return quick_two_sum(f32(value & 0xffff0000u), f32(value & 0xffffu));
}

// -a.
fn negate_two(a: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(-a.x, -a.y);
}

// |a|.
fn absolute_two(a: vec2<f32>) -> vec2<f32> {
    return select(a, negate_two(a), a.x < 0.0);
}

// a + b.
fn add_two(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    let high = two_sum(a.x, b.x);
    let low = two_sum(a.y, b.y);
    let sum = quick_two_sum(high.x, high.y + low.x);
    return quick_two_sum(sum.x, low.y + sum.y);
}

// a - b.
fn subtract_two(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return add_two(a, negate_two(b));
}

// a b, the same as b a.
fn multiply_two(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    let product = two_product(a.x, b.x);
    let across = a.x * b.y + a.y * b.x;
    return quick_two_sum(product.x, product.y + across);
}

// a b for an f32 b.
fn scale_two(a: vec2<f32>, b: f32) -> vec2<f32> {
    let product = two_product(a.x, b);
    let sum = quick_two_sum(product.x, a.y * b);
    return quick_two_sum(sum.x, sum.y + product.y);
}

// a / b.
fn divide_two(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    let quotient = divide_f32(a.x, b.x);
    let product = scale_two(b, quotient);
    let rest = (a.x - product.x) + (a.y - product.y);
    return quick_two_sum(quotient, divide_f32(rest, b.x));
}

// The square root of a; 0 of 0.
fn square_root_two(a: vec2<f32>) -> vec2<f32> {
    if a.x == 0.0 {
        return a;
    }
    let root = square_root_f32(a.x);
    let square = two_product(root, root);
    let rest = ((a.x - square.x) - square.y) + a.y;
    return quick_two_sum(root, divide_f32(rest, 2.0 * root));
}

// a < b.
fn less_two(a: vec2<f32>, b: vec2<f32>) -> bool {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// a <= b.
fn less_or_equal_two(a: vec2<f32>, b: vec2<f32>) -> bool {
    return a.x < b.x || (a.x == b.x && a.y <= b.y);
}

// a = b.
fn equal_two(a: vec2<f32>, b: vec2<f32>) -> bool {
    return a.x == b.x && a.y == b.y;
}

// The smaller of two numbers.
fn least_two(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return select(a, b, less_two(b, a));
}

// The larger of two numbers.
fn greatest_two(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return select(a, b, less_two(a, b));
}

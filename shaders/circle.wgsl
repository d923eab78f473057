// Points of the unit circle and of the unit disk, without a device's sine.

// The sine of 2 pi t over t as a polynomial of t^2, by which the sine is off by 4.3e-9 at most
// where |t| <= 1/8 (Remez, all but the first coefficient).
const SINE: vec4<f32> = vec4<f32>(6.2831855, -41.341747, 81.60243, -75.74232);

// The cosine of 2 pi t less 1, over t^2, likewise: 4e-10.
const COSINE: vec4<f32> = vec4<f32>(-19.739208, 64.93914, -85.42312, 58.561092);

// The point at a `turn` of -1/8 to 1/8.
fn near_point(turn: f32) -> vec2<f32> {
    let square = turn * turn;
    let sine = SINE.x + square * (SINE.y + square * (SINE.z + square * SINE.w));
    let cosine = COSINE.x + square * (COSINE.y + square * (COSINE.z + square * COSINE.w));
    return vec2<f32>(1.0 + square * cosine, turn * sine);
}

// The cosine and the sine of 2 pi `turn`, a turn of 0 to 1: each off by 2^-23 at most.
//
// The nearest quarter is taken away, exactly, and what is left is in reach of a polynomial.
fn circle_point(turn: f32) -> vec2<f32> {
    let quarters = floor(turn * 4.0 + 0.5);
    let near = near_point(turn - quarters * 0.25);
    let quadrant = i32(quarters) & 3;
    let odd = (quadrant & 1) == 1;
    let x = select(near.x, near.y, odd);
    let y = select(near.y, near.x, odd);
    let left = quadrant == 1 || quadrant == 2;
    let below = quadrant >= 2;
    return vec2<f32>(select(x, -x, left), select(y, -y, below));
}

// The point of the unit disk for one of the unit square, so that areas keep their ratio and
// neighbours stay neighbours. It may be 3 2^-24 outside the circle.
//
// Shirley, Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools
// 2(3), 1997.
fn disk_point(pair: vec2<f32>) -> vec2<f32> {
    let x = pair.x * 2.0 - 1.0;
    let y = pair.y * 2.0 - 1.0;
    if x == 0.0 && y == 0.0 {
        return vec2<f32>(0.0, 0.0);
    }
    let wide = abs(x) > abs(y);
    let radius = select(y, x, wide);
    let other = select(x, y, wide);
    let near = near_point(divide_f32(other, radius) * 0.125);
    let along = radius * near.x;
    let across = radius * near.y;
    return vec2<f32>(select(across, along, wide), select(along, across, wide));
}

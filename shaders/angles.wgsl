// Angles of points, in turns, and back: where a direction lies on a map of the sphere.

// atan(t) / (2 pi t) as a polynomial of t^2 that is off by 7.3e-9 of a turn at most where
// |t| <= 1 (Remez).
const ARCTANGENT: array<f32, 8> = array<f32, 8>(
    0.15915485,
    -0.05304636,
    0.031747796,
    -0.0221427,
    0.015357238,
    -0.008908684,
    0.0034837862,
    -0.00064592843,
);

// asin(s) / (pi s) as a polynomial of s^2 that is off by 4.1e-8 of it at most where
// |s| <= 1/2 (Remez).
const ARCSINE: array<f32, 6> = array<f32, 6>(
    0.31830987,
    0.05305204,
    0.023855526,
    0.014499074,
    0.0075942944,
    0.0135713415,
);

// The angle of the point (x, y) in turns, from the first axis towards the second: from 0 up
// to but not 1, off by 2^-23 at most. That of (0, 0) is 0.
fn turn_of(x: f32, y: f32) -> f32 {
    let across = abs(x);
    let upward = abs(y);
    let steep = upward > across;
    let larger = select(across, upward, steep);
    let smaller = select(upward, across, steep);
    if larger == 0.0 {
        return 0.0;
    }
    let tangent = divide_f32(smaller, larger);
    let square = tangent * tangent;
    let high = ARCTANGENT[5] + square * (ARCTANGENT[6] + square * ARCTANGENT[7]);
    let upper = ARCTANGENT[3] + square * (ARCTANGENT[4] + square * high);
    let lower = ARCTANGENT[1] + square * (ARCTANGENT[2] + square * upper);
    let eighth = tangent * (ARCTANGENT[0] + square * lower);
    let quarter = select(eighth, 0.25 - eighth, steep);
    let half = select(quarter, 0.5 - quarter, x < 0.0);
    let turn = select(half, 1.0 - half, y < 0.0);
    // Less than half a rounding below 1.
    return select(turn, 0.0, turn >= 1.0);
}

// acos(z) / pi: the angle from the pole at z = 1 in half turns, from 0 to 1, off by 2^-23 at
// most, and by 2^-22 of itself. A `z` beyond -1 to 1 counts as the nearest of these.
//
// Near the poles, where acos is steep, by the sine of half the angle, whose square is exact.
fn polar_turn(z: f32) -> f32 {
    let size = abs(z);
    let near_pole = size > 0.5;
    let rest = select(0.0, (1.0 - size) * 0.5, size < 1.0);
    let root = square_root_f32(rest);
    let sine = select(size, root, near_pole);
    let square = select(size * size, rest, near_pole);
    let high = ARCSINE[3] + square * (ARCSINE[4] + square * ARCSINE[5]);
    let sum = ARCSINE[0] + square * (ARCSINE[1] + square * (ARCSINE[2] + square * high));
    let turn = sine * sum;
    let from_pole = select(0.5 - turn, turn * 2.0, near_pole);
    return select(from_pole, 1.0 - from_pole, z < 0.0);
}

// cos(pi `turn`) of 0 to 1: the height on the unit sphere at this angle from the pole, in
// half turns; off by 2^-23 at most.
fn polar_z(turn: f32) -> f32 {
    return circle_point(turn * 0.5).x;
}

//! Angles of points, in turns, and back: where a direction lies on a map of the sphere.

use super::circle::circle_point;
use super::divide::{divide, square_root};

/// atan(t) / (2 pi t) as a polynomial of t^2 that is off by 7.3e-9 of a turn at most where
/// |t| <= 1 (Remez).
const ARCTANGENT: [f32; 8] = [
    0.15915485,
    -0.05304636,
    0.031747796,
    -0.0221427,
    0.015357238,
    -0.008908684,
    0.0034837862,
    -0.00064592843,
];

/// asin(s) / (pi s) as a polynomial of s^2 that is off by 4.1e-8 of it at most where
/// |s| <= 1/2 (Remez).
const ARCSINE: [f32; 6] = [
    0.31830987,
    0.05305204,
    0.023855526,
    0.014499074,
    0.0075942944,
    0.0135713415,
];

/// The angle of the point (x, y) in turns, from the first axis towards the second: from 0 up
/// to but not 1, off by 2^-23 at most. That of (0, 0) is 0.
pub fn turn_of(x: f32, y: f32) -> f32 {
    let across = x.abs();
    let upward = y.abs();
    let steep = upward > across;
    let larger = if steep { upward } else { across };
    let smaller = if steep { across } else { upward };
    if larger == 0.0 {
        return 0.0;
    }
    let tangent = divide(smaller, larger);
    let square = tangent * tangent;
    let high = ARCTANGENT[5] + square * (ARCTANGENT[6] + square * ARCTANGENT[7]);
    let upper = ARCTANGENT[3] + square * (ARCTANGENT[4] + square * high);
    let lower = ARCTANGENT[1] + square * (ARCTANGENT[2] + square * upper);
    let eighth = tangent * (ARCTANGENT[0] + square * lower);
    let quarter = if steep { 0.25 - eighth } else { eighth };
    let half = if x < 0.0 { 0.5 - quarter } else { quarter };
    let turn = if y < 0.0 { 1.0 - half } else { half };
    // Less than half a rounding below 1.
    if turn >= 1.0 { 0.0 } else { turn }
}

/// acos(z) / pi: the angle from the pole at z = 1 in half turns, from 0 to 1, off by 2^-23 at
/// most, and by 2^-22 of itself. A `z` beyond -1 to 1 counts as the nearest of these.
///
/// Near the poles, where acos is steep, by the sine of half the angle, whose square is exact.
pub fn polar_turn(z: f32) -> f32 {
    let size = z.abs();
    let near_pole = size > 0.5;
    let rest = if size < 1.0 { (1.0 - size) * 0.5 } else { 0.0 };
    let root = square_root(rest);
    let sine = if near_pole { root } else { size };
    let square = if near_pole { rest } else { size * size };
    let high = ARCSINE[3] + square * (ARCSINE[4] + square * ARCSINE[5]);
    let sum = ARCSINE[0] + square * (ARCSINE[1] + square * (ARCSINE[2] + square * high));
    let turn = sine * sum;
    let from_pole = if near_pole { turn * 2.0 } else { 0.5 - turn };
    if z < 0.0 { 1.0 - from_pole } else { from_pole }
}

/// cos(pi `turn`) of 0 to 1: the height on the unit sphere at this angle from the pole, in
/// half turns; off by 2^-23 at most.
pub fn polar_z(turn: f32) -> f32 {
    circle_point(turn * 0.5)[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Numbers;
    use std::f64::consts::{PI, TAU};

    /// An ulp of numbers from 1/2 to 1 is 2^-24; three sums of up to half an ulp and the
    /// polynomial make less than two.
    const MOST: f64 = 1.0 / (1 << 23) as f64;

    fn points() -> Vec<[f32; 2]> {
        let mut random = Numbers(3);
        let mut points = Vec::new();
        for _ in 0..300_000 {
            let angle = random.between(0.0, TAU);
            let radius = 2.0_f64.powf(random.between(-60.0, 60.0));
            let flat = 2.0_f64.powf(random.between(-40.0, 0.0));
            let [x, y] = [radius * angle.cos(), radius * angle.sin()];
            points.push([x as f32, y as f32]);
            points.push([x as f32, (y * flat) as f32]);
            points.push([(x * flat) as f32, y as f32]);
        }
        points
    }

    /// The largest error, the long way round as short as the other.
    fn worst_turn(found: impl Fn(f32, f32) -> f32) -> f64 {
        points().into_iter().fold(0.0, |worst: f64, [x, y]| {
            let exact = f64::from(y).atan2(f64::from(x)) / TAU;
            let off = f64::from(found(x, y)) - exact;
            worst.max((off - off.round()).abs())
        })
    }

    #[test]
    fn turns_are_near() {
        let worst = worst_turn(turn_of);
        println!("worst error: {worst:e}");
        assert!(worst < MOST, "{worst:e}");
        // The control: Rajan et al., "Efficient approximations for the arctangent function",
        // 2006, is off by 0.0015 radians.
        let rough = |x: f32, y: f32| {
            let t = (y / x).abs();
            if x < 0.0 || y < 0.0 || t > 1.0 {
                return turn_of(x, y);
            }
            t * 0.125 + t * (1.0 - t) * (0.2447 + 0.0663 * t) / TAU as f32
        };
        let worst = worst_turn(rough);
        assert!(worst > 1e-4 && worst < 1e-3, "{worst:e}");
    }

    #[test]
    fn turns_are_within_a_turn() {
        for [x, y] in points() {
            assert!((0.0..1.0).contains(&turn_of(x, y)), "{x:e}, {y:e}");
        }
        assert_eq!(turn_of(1.0, -1e-30), 0.0);
        assert_eq!([turn_of(0.0, 0.0), turn_of(-0.0, -0.0)], [0.0; 2]);
        let quarters = [[2.0, 0.0], [0.0, 2.0], [-2.0, 0.0], [0.0, -2.0]];
        assert_eq!(quarters.map(|[x, y]| turn_of(x, y)), [0.0, 0.25, 0.5, 0.75]);
    }

    /// All heights of these steps, and those next to the poles.
    fn heights() -> impl Iterator<Item = f32> {
        let even = (-1 << 19..=1 << 19).map(|i| i as f32 / (1 << 19) as f32);
        let near = (0..4096).map(|i| f32::from_bits(1f32.to_bits() - i));
        even.chain(near.flat_map(|z| [z, -z]))
    }

    #[test]
    fn polar_turns_are_near() {
        let (mut worst, mut relative, mut plain) = (0.0, 0.0, 0.0);
        for z in heights() {
            let exact = f64::from(z).acos() / PI;
            let off = (f64::from(polar_turn(z)) - exact).abs();
            worst = f64::max(worst, off);
            if exact > 0.0 {
                relative = f64::max(relative, off / exact);
                // The control: a right angle less the arcsine, in f32.
                let other = f64::from((f64::from(z).asin() / PI) as f32);
                let other = 0.5 - other;
                plain = f64::max(plain, (other - exact).abs() / exact);
            }
        }
        println!("worst error: {worst:e}, relative {relative:e}");
        assert!(worst < MOST, "{worst:e}");
        assert!(relative < 2.0 * MOST, "{relative:e}");
        assert!(plain > 4.0 * MOST, "the control: {plain:e}");
        let special = [1.0, 2.0, f32::INFINITY, 0.0, -0.0, -1.0, -2.0];
        let expected = [0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0];
        assert_eq!(special.map(polar_turn), expected);
    }

    #[test]
    fn heights_are_near_and_back() {
        let mut worst = 0.0;
        for i in 0..=1 << 20 {
            let turn = i as f32 / (1 << 20) as f32;
            let exact = (f64::from(turn) * PI).cos();
            worst = f64::max(worst, (f64::from(polar_z(turn)) - exact).abs());
        }
        println!("worst error: {worst:e}");
        assert!(worst < MOST, "{worst:e}");
        assert_eq!([0.0, 0.5, 1.0].map(polar_z), [1.0, 0.0, -1.0]);
        for z in heights() {
            let back = polar_z(polar_turn(z));
            // An error of a turn is pi times as much of a height.
            let off = f64::from(back - z).abs();
            assert!(off < (PI + 1.0) * MOST, "{z}: {back}");
        }
    }
}

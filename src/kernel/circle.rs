//! Points of the unit circle and of the unit disk, without a device's sine.

use super::divide::divide;

/// The sine of 2 pi t over t as a polynomial of t^2, by which the sine is off by 4.3e-9 at most
/// where |t| <= 1/8 (Remez, all but the first coefficient).
const SINE: [f32; 4] = [std::f32::consts::TAU, -41.341747, 81.60243, -75.74232];

/// The cosine of 2 pi t less 1, over t^2, likewise: 4e-10.
const COSINE: [f32; 4] = [-19.739208, 64.93914, -85.42312, 58.561092];

/// The point at a `turn` of -1/8 to 1/8.
fn near_point(turn: f32) -> [f32; 2] {
    let square = turn * turn;
    let sine = SINE[0] + square * (SINE[1] + square * (SINE[2] + square * SINE[3]));
    let cosine = COSINE[0] + square * (COSINE[1] + square * (COSINE[2] + square * COSINE[3]));
    [1.0 + square * cosine, turn * sine]
}

/// The cosine and the sine of 2 pi `turn`, a turn of 0 to 1: each off by 2^-23 at most.
///
/// The nearest quarter is taken away, exactly, and what is left is in reach of a polynomial.
pub fn circle_point(turn: f32) -> [f32; 2] {
    let quarters = (turn * 4.0 + 0.5).floor();
    let near = near_point(turn - quarters * 0.25);
    let quadrant = (quarters as i32) & 3;
    let odd = (quadrant & 1) == 1;
    let x = if odd { near[1] } else { near[0] };
    let y = if odd { near[0] } else { near[1] };
    let left = quadrant == 1 || quadrant == 2;
    let below = quadrant >= 2;
    [if left { -x } else { x }, if below { -y } else { y }]
}

/// The point of the unit disk for one of the unit square, so that areas keep their ratio and
/// neighbours stay neighbours. It may be 3 2^-24 outside the circle.
///
/// Shirley, Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools
/// 2(3), 1997.
pub fn disk_point(pair: [f32; 2]) -> [f32; 2] {
    let x = pair[0] * 2.0 - 1.0;
    let y = pair[1] * 2.0 - 1.0;
    if x == 0.0 && y == 0.0 {
        return [0.0, 0.0];
    }
    let wide = x.abs() > y.abs();
    let radius = if wide { x } else { y };
    let other = if wide { y } else { x };
    let near = near_point(divide(other, radius) * 0.125);
    let along = radius * near[0];
    let across = radius * near[1];
    [
        if wide { along } else { across },
        if wide { across } else { along },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// An ulp of numbers from 1/2 to 1 is 2^-24. A sine has three roundings of up to half an
    /// ulp, those of the polynomial, of its first coefficient and of the product, beside the
    /// polynomial's error; that makes less than two.
    const MOST: f64 = 1.0 / (1 << 23) as f64;

    fn off([x, y]: [f32; 2], [cosine, sine]: [f64; 2]) -> f64 {
        (f64::from(x) - cosine)
            .abs()
            .max((f64::from(y) - sine).abs())
    }

    /// The largest error over turns from 0 to `reach`.
    fn worst_over_turns(reach: f32, point: impl Fn(f32) -> [f32; 2]) -> f64 {
        let steps = 1 << 20;
        (0..steps).fold(0.0, |worst, step| {
            let turn = step as f32 / steps as f32 * reach;
            let (sine, cosine) = (TAU * f64::from(turn)).sin_cos();
            off(point(turn), [cosine, sine]).max(worst)
        })
    }

    #[test]
    fn turns_are_those_of_sine_and_cosine() {
        let worst = worst_over_turns(1.0, circle_point);
        println!("worst error: {worst:e}");
        assert!(worst < MOST, "{worst:e}");
        // The control: a polynomial of a term less.
        let short = |turn: f32| {
            let square = turn * turn;
            let sine = SINE[0] + square * (SINE[1] + square * SINE[2]);
            [near_point(turn)[0], turn * sine]
        };
        assert!(worst_over_turns(0.125, near_point) < MOST);
        assert!(worst_over_turns(0.125, short) > MOST);
    }

    #[test]
    fn quarters_are_exact() {
        let quarters = [0.0, 0.25, 0.5, 0.75].map(circle_point);
        assert_eq!(quarters, [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]);
        // The last turn below 1, and a tiny one.
        let [x, y] = circle_point(1f32.next_down());
        assert!(x == 1.0 && y < 0.0 && y > -1e-6);
        let [x, y] = circle_point(1e-30);
        assert!(x == 1.0 && (y / 1e-30 - TAU as f32).abs() < 1e-5);
    }

    /// Half of the points for each half of the area.
    #[test]
    fn the_disk_is_filled_evenly() {
        let size = 512;
        let at = |i: i32| i as f32 / size as f32;
        let mut outermost: f64 = 0.0;
        let (mut inside, mut right, mut worst) = (0, 0, 0.0_f64);
        for i in 0..size * size {
            let pair = [at(i % size), at(i / size)];
            let point = disk_point(pair);
            let [x, y] = point.map(f64::from);
            outermost = outermost.max(x.hypot(y));
            // Half of the area lies within the root of 1/2, the square's middle.
            let radius = pair
                .map(|p| (2.0 * f64::from(p) - 1.0).abs())
                .into_iter()
                .fold(0.0, f64::max);
            worst = worst.max((x.hypot(y) - radius).abs());
            inside += i32::from(x * x + y * y < 0.5);
            right += i32::from(x > 0.0);
        }
        println!(
            "worst radius: {worst:e}, outermost: 1 + {:e}",
            outermost - 1.0
        );
        assert!(worst < MOST + MOST / 2.0);
        assert!(outermost <= 1.0 + 3.0 / (1 << 24) as f64);
        // Along the edges of either area a row of points belongs to neither side.
        let edge = 4 * size;
        assert!((inside - size * size / 2).abs() < edge, "{inside}");
        assert!((right - size * size / 2).abs() < edge, "{right}");
        assert_eq!(disk_point([0.5, 0.5]), [0.0, 0.0]);
    }

    /// The angle grows evenly along a square's side.
    #[test]
    fn the_map_is_the_concentric_one() {
        for step in 0..=256 {
            let other = step as f32 / 256.0;
            let angle = (2.0 * f64::from(other) - 1.0) * TAU / 8.0;
            let low = disk_point([other, 0.0]);
            assert!(off(low, [angle.sin(), -angle.cos()]) < MOST, "{low:?}");
            let left = disk_point([0.0, other]);
            assert!(off(left, [-angle.cos(), angle.sin()]) < MOST, "{left:?}");
        }
    }
}

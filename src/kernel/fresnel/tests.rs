//! Against Fresnel's equations in f64, and against what is known of their values.

use super::*;

/// Of each rounding, in parts of the number.
const ROUNDING: f64 = 1.0 / (1 << 24) as f64;

/// Sums, products and quotients after the root.
const LAST: f64 = 10.0 * ROUNDING;

/// In f64, from the square of the cosine beyond.
fn exact(cosine: f64, ratio: f64, square: f64) -> f64 {
    if square <= 0.0 {
        return 1.0;
    }
    let beyond = square.sqrt();
    let across = (ratio * cosine - beyond) / (ratio * cosine + beyond);
    let along = (cosine - ratio * beyond) / (cosine + ratio * beyond);
    (across * across + along * along) / 2.0
}

fn cosines() -> impl Iterator<Item = f32> {
    (0..=4096).map(|step| step as f32 / 4096.0)
}

const RATIOS: [f32; 8] = [0.25, 0.4, 1.0 / 1.5, 0.99, 1.0, 1.01, 1.5, 4.0];

/// How far from the equations: 0 where the result is among what they give for a square of the
/// cosine beyond that is off by no more than its roundings make it.
fn off(found: f32, cosine: f32, ratio: f32) -> f64 {
    let [cosine, ratio] = [cosine, ratio].map(f64::from);
    let [first, second] = [1.0 - ratio * ratio, (ratio * cosine).powi(2)];
    let square = first + second;
    // Three roundings each, and that of the sum.
    let most = ROUNDING * (3.0 * (first.abs() + second) + square.abs());
    let around =
        (-64..=64).map(|step| exact(cosine, ratio, square + most * f64::from(step) / 64.0));
    let (low, high) = around.fold((1.0f64, 0.0f64), |(low, high), found| {
        (low.min(found), high.max(found))
    });
    let found = f64::from(found);
    (low - found).max(found - high).max(0.0)
}

#[test]
fn clear_surfaces_throw_back_what_fresnel_says() {
    for ratio in RATIOS {
        for cosine in cosines() {
            let found = thrown_back(cosine, ratio);
            assert!((0.0..=1.0).contains(&found), "{cosine}, {ratio}: {found}");
            let off = off(found, cosine, ratio);
            assert!(off <= LAST, "{cosine}, {ratio}: off by {off:e}");
        }
    }
    // The control: Schlick's guess of the same.
    let straight = 0.04;
    let worst = cosines().map(|cosine| {
        let guess = askew(vec3(straight, straight, straight), cosine).x;
        off(guess, cosine, 1.0 / 1.5)
    });
    assert!(worst.fold(0.0, f64::max) > 0.01);
}

#[test]
fn straight_on_it_is_the_square_of_the_indices_difference_by_their_sum() {
    for index in [1.0f64, 1.33, 1.5, 2.4, 4.0] {
        let expected = ((index - 1.0) / (index + 1.0)).powi(2);
        for ratio in [index, 1.0 / index] {
            let found = f64::from(thrown_back(1.0, ratio as f32));
            // The index is rounded, which its difference to 1 feels.
            let most = LAST + 4.0 * ROUNDING * index;
            assert!((found - expected).abs() <= most, "{ratio}: {found}");
        }
    }
}

#[test]
fn what_grazes_is_thrown_back_whole() {
    for ratio in RATIOS {
        assert_eq!(thrown_back(0.0, ratio), 1.0);
        let near = f64::from(thrown_back(1e-4, ratio));
        // To first order in the cosine it lacks 2 c (r + 1 / r) / root(1 - r^2) below r = 1.
        if ratio < 0.9 {
            let ratio = f64::from(ratio);
            let lack = 2e-4 * (ratio + 1.0 / ratio) / (1.0 - ratio * ratio).sqrt();
            assert!(
                (near - (1.0 - lack)).abs() < lack * lack + LAST,
                "{ratio}: {near}"
            );
        }
    }
}

/// Where the way thrown back would be at right angles to the way through, light whose field is
/// along the plane of both goes through whole.
#[test]
fn at_brewsters_angle_half_of_it_is_not_thrown_back() {
    for ratio in [0.25f64, 1.0 / 1.5, 0.8, 1.25, 1.5] {
        // The tangent is 1 / ratio.
        let cosine = ratio / (1.0 + ratio * ratio).sqrt();
        let square = ratio * ratio;
        let expected = ((1.0 - square) / (1.0 + square)).powi(2) / 2.0;
        let found = f64::from(thrown_back(cosine as f32, ratio as f32));
        assert!((found - expected).abs() <= LAST, "{ratio}: {found}");
    }
}

/// As much is thrown back on the way in as on the same way out.
#[test]
fn both_ways_are_alike() {
    for index in [1.1f64, 1.5, 2.4] {
        for cosine in cosines().skip(64) {
            let sine = (1.0 - f64::from(cosine).powi(2)).sqrt() / index;
            let beyond = (1.0 - sine * sine).sqrt();
            let into = f64::from(thrown_back(cosine, (1.0 / index) as f32));
            let out = f64::from(thrown_back(beyond as f32, index as f32));
            // On the way out, the square of the cosine is off by some roundings times the
            // index's, and the root of it, at least 1/64, by as many times 32; it counts at
            // most four times.
            let most = 5.0 * ROUNDING * index * index * 32.0 * 4.0;
            assert!(
                (into - out).abs() < most,
                "{index}, {cosine}: {into}, {out}"
            );
        }
    }
}

/// A body of air is not there.
#[test]
fn like_indices_throw_back_nothing() {
    for cosine in cosines().skip(1) {
        assert_eq!(thrown_back(cosine, 1.0), 0.0);
    }
}

#[test]
fn what_comes_too_slanted_from_within_is_thrown_back_whole() {
    for index in [1.2f32, 1.5, 4.0] {
        let critical = (1.0 - 1.0 / (index * index)).sqrt();
        assert_eq!(thrown_back(critical * 0.999, index), 1.0);
        assert!(thrown_back(critical * 1.001, index) < 1.0);
    }
}

#[test]
fn mirrors_throw_back_more_askew() {
    let straight = vec3(0.04, 0.5, 1.0);
    assert_eq!(askew(straight, 1.0), straight);
    assert_eq!(askew(straight, 0.0), vec3(1.0, 1.0, 1.0));
    let mut last = vec3(1.0, 1.0, 1.0);
    for cosine in cosines() {
        let now = askew(straight, cosine);
        let part = (1.0 - f64::from(cosine)).powi(5);
        let expected = 0.04 + 0.96 * part;
        assert!(
            (f64::from(now.x) - expected).abs() < 4.0 * ROUNDING,
            "{cosine}"
        );
        assert!(
            now.x <= last.x && now.y <= last.y && now.z == 1.0,
            "{cosine}"
        );
        last = now;
    }
}

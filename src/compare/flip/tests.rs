use super::*;
use crate::frame::transfer::srgb_decode;

const WIDTH: usize = 48;
const HEIGHT: usize = 40;

/// What the authors' own program (Python package `flip-evaluator` 1.7, `LDR`,
/// inputs in sRGB, f32) gives for [`pair`]: the mean of the error map, and the
/// map at x, y = 30, 11; 21, 5; 0, 0.
struct Case {
    name: &'static str,
    pixels_per_degree: f64,
    mean: f64,
    at: [f64; 3],
}

#[rustfmt::skip]
const CASES: [Case; 14] = [
    Case { name: "flat", pixels_per_degree: 67.0, mean: 0.219514, at: [0.219514, 0.219514, 0.219514] },
    Case { name: "flat", pixels_per_degree: 20.0, mean: 0.219523, at: [0.219523, 0.219523, 0.219523] },
    Case { name: "extremes", pixels_per_degree: 67.0, mean: 0.967392, at: [0.967392, 0.967392, 0.967392] },
    Case { name: "extremes", pixels_per_degree: 20.0, mean: 0.967391, at: [0.967391, 0.967391, 0.967391] },
    Case { name: "greenblue", pixels_per_degree: 67.0, mean: 1.000000, at: [1.000000, 1.000000, 1.000000] },
    Case { name: "greenblue", pixels_per_degree: 20.0, mean: 1.000000, at: [1.000000, 1.000000, 1.000000] },
    Case { name: "waves", pixels_per_degree: 67.0, mean: 0.307859, at: [0.262564, 0.305813, 0.406920] },
    Case { name: "waves", pixels_per_degree: 20.0, mean: 0.289254, at: [0.234779, 0.282610, 0.374490] },
    Case { name: "edge", pixels_per_degree: 67.0, mean: 0.142901, at: [0.014448, 0.954472, 0.000000] },
    Case { name: "edge", pixels_per_degree: 20.0, mean: 0.084030, at: [0.000000, 0.964909, 0.000000] },
    Case { name: "dot", pixels_per_degree: 67.0, mean: 0.006013, at: [0.506427, 0.000671, 0.000000] },
    Case { name: "dot", pixels_per_degree: 20.0, mean: 0.002817, at: [0.978965, 0.000000, 0.000000] },
    Case { name: "checker", pixels_per_degree: 67.0, mean: 0.523352, at: [0.512003, 0.514686, 0.610602] },
    Case { name: "checker", pixels_per_degree: 20.0, mean: 0.825671, at: [0.865520, 0.773856, 0.933779] },
];

/// The program works in f32, and the square root of the feature difference
/// makes an error of its half scale, sqrt(2^-24) = 2.4e-4, out of one rounding.
const TOLERANCE: f64 = 2.5e-4;

/// One pixel of both pictures of a case, in sRGB.
fn pixel(name: &str, x: usize, y: usize) -> ([f64; 3], [f64; 3]) {
    let (fx, fy) = (x as f64, y as f64);
    let (w, h) = (WIDTH as f64, HEIGHT as f64);
    match name {
        "flat" => ([0.2, 0.4, 0.6], [0.3, 0.4, 0.5]),
        "extremes" => ([0.0; 3], [1.0; 3]),
        "greenblue" => ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
        "waves" => (
            [
                0.5 + 0.5 * (0.3 * fx).sin(),
                0.5 + 0.5 * (0.2 * fy).cos(),
                (fx + fy) / (w + h),
            ],
            [
                0.5 + 0.5 * (0.3 * fx + 0.1).sin(),
                0.5 + 0.45 * (0.2 * fy).cos(),
                (fx + 2.0 * fy) / (w + 2.0 * h),
            ],
        ),
        "edge" => {
            let side = |border| {
                if x < border {
                    [0.9, 0.2, 0.1]
                } else {
                    [0.0; 3]
                }
            };
            (side(20), side(23))
        }
        "dot" if (x, y) == (30, 11) => ([0.25; 3], [1.0, 0.8, 0.1]),
        "dot" => ([0.25; 3], [0.25; 3]),
        "checker" => ([0.5; 3], [((x + y) % 2) as f64; 3]),
        _ => unreachable!("no case is named {name}"),
    }
}

fn pair(name: &str) -> (Vec<[f32; 3]>, Vec<[f32; 3]>) {
    let pixels = (0..WIDTH * HEIGHT).map(|i| pixel(name, i % WIDTH, i / WIDTH));
    let linear = |srgb: [f64; 3]| srgb.map(|c| srgb_decode(c) as f32);
    pixels.map(|(a, b)| (linear(a), linear(b))).unzip()
}

#[test]
fn agrees_with_the_authors_program() {
    for case in &CASES {
        let (left, right) = pair(case.name);
        let map = error_map(&left, &right, WIDTH, HEIGHT, case.pixels_per_degree);
        let at = [(30, 11), (21, 5), (0, 0)].map(|(x, y)| f64::from(map[y * WIDTH + x]));
        let ours = [mean(&map), at[0], at[1], at[2]];
        let theirs = [case.mean, case.at[0], case.at[1], case.at[2]];
        for (ours, theirs) in ours.into_iter().zip(theirs) {
            assert!(
                (ours - theirs).abs() < TOLERANCE,
                "{} at {}: {ours} for {theirs}",
                case.name,
                case.pixels_per_degree
            );
        }
    }
}

#[test]
fn is_symmetric_and_zero_for_equals() {
    let (left, right) = pair("waves");
    let map = |a: &[[f32; 3]], b: &[[f32; 3]]| error_map(a, b, WIDTH, HEIGHT, PIXELS_PER_DEGREE);
    assert_eq!(map(&left, &right), map(&right, &left));
    assert_eq!(mean(&map(&left, &left)), 0.0);
    assert!(mean(&map(&left, &right)) > 0.3);
}

#[test]
fn bands_do_not_show() {
    // Taller than a band, the same in every row: so is the error.
    let (width, height) = (5, 2 * BAND + 3);
    let row = |c: f32| [[0.1, c, 0.9], [0.4; 3], [c; 3], [0.0; 3], [0.7, 0.7, c]];
    let (left, right) = (row(0.2).repeat(height), row(0.6).repeat(height));
    let map = error_map(&left, &right, width, height, PIXELS_PER_DEGREE);
    assert!(map[2] > 0.1);
    for (i, error) in map.iter().enumerate() {
        assert_eq!(*error, map[i % width], "row {}", i / width);
    }
}

#[test]
fn one_pixel_and_odd_distances() {
    for distance in [f64::MIN_POSITIVE, 1e300, f64::INFINITY] {
        let map = error_map(&[[0.0; 3]], &[[1.0; 3]], 1, 1, distance);
        assert!(map[0] > 0.9 && map[0] <= 1.0, "{distance} {map:?}");
    }
    assert!(error_map(&[], &[], 0, 0, PIXELS_PER_DEGREE).is_empty());
}

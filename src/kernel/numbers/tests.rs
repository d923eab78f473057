//! What the numbers are to be, each with a control that is not so.

use super::*;

const PIXELS: [[u32; 3]; 5] = [
    [0, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [7, 640, 359],
    [1, 3839, 2159],
];
const DIMENSIONS: [u32; 4] = [0, 1, 2, 40];

/// Standard deviations that chance does not reach: in one of a million tries or so.
const FAR: f64 = 5.0;

/// Of a number evenly in \[0, 1).
const VARIANCE: f64 = 1.0 / 12.0;

/// By how much the variance of a mean over samples exceeds that of independent ones. Of
/// samples 2 i and 2 i + 1, one is in each half of each axis, so the products of their first
/// bits agree, which doubles it; the products of others add less.
const DEPENDENT: f64 = 2.0;

fn pairs(pixel: [u32; 3], dimension: u32, samples: std::ops::Range<u32>) -> Vec<[f32; 2]> {
    let [seed, x, y] = pixel;
    samples
        .map(|sample| number_pair(numbers_of(seed, x, y, sample), dimension))
        .collect()
}

/// Whether each rectangle into which halving divides the square has one of the points; their
/// number is a power of two.
fn is_net(points: &[[f32; 2]]) -> bool {
    let bits = points.len().ilog2();
    (0..=bits).all(|across| {
        let [width, height] = [across, bits - across].map(|bits| 1_usize << bits);
        let mut taken = vec![false; points.len()];
        points.iter().all(|[x, y]| {
            let cell = (x * width as f32) as usize + width * (y * height as f32) as usize;
            !std::mem::replace(&mut taken[cell], true)
        })
    })
}

/// Sobol's second coordinate, by its direction numbers.
fn by_directions(index: u32) -> u32 {
    let mut direction = 1 << 31;
    let mut sum = 0;
    for bit in 0..32 {
        if index >> bit & 1 == 1 {
            sum ^= direction;
        }
        direction ^= direction >> 1;
    }
    sum
}

#[test]
fn the_second_coordinate_is_that_of_the_direction_numbers() {
    for index in (0..4096).chain((0..4096).map(|i: u32| !(i * 1_000_003))) {
        let coordinate = second_coordinate(index).reverse_bits();
        assert_eq!(coordinate, by_directions(index), "{index}");
    }
}

#[test]
fn every_prefix_is_a_net() {
    let plain = |i: u32| [from_reversed(i), from_reversed(second_coordinate(i))];
    for bits in 0..=10 {
        let unscrambled: Vec<[f32; 2]> = (0..1 << bits).map(plain).collect();
        assert!(is_net(&unscrambled), "{bits}");
        for pixel in PIXELS {
            for dimension in DIMENSIONS {
                let points = pairs(pixel, dimension, 0..1 << bits);
                assert!(is_net(&points), "{pixel:?}, {dimension}: {bits}");
            }
        }
    }
    // As many that follow.
    assert!(is_net(&pairs(PIXELS[3], 1, 5 << 9..6 << 9)));
    // The controls: not from a multiple of their number on, and numbers that are just mixed.
    assert!(!is_net(&pairs(PIXELS[3], 1, 100..100 + 512)));
    let mixed = |i| pcg3d(i, 0, 0).map(from_reversed);
    let mixed: Vec<[f32; 2]> = (0..16).map(mixed).map(|[x, y, _]| [x, y]).collect();
    assert!(!is_net(&mixed));
}

/// Low bits know nothing of higher ones, and none is lost.
#[test]
fn a_scramble_is_nested() {
    for key in [0, 1, 0x8000_0000, 0x1234_5678, u32::MAX] {
        for bits in [1, 4, 12] {
            let mask = (1 << bits) - 1;
            let mut taken = vec![false; 1 << bits];
            for low in 0..1_u32 << bits {
                let scrambled_low = scrambled(low, key) & mask;
                let high = low | !mask & low.wrapping_mul(0x9e37_79b9);
                assert_eq!(scrambled(high, key) & mask, scrambled_low, "{key:x}");
                assert!(!std::mem::replace(&mut taken[scrambled_low as usize], true));
            }
        }
    }
}

#[test]
fn numbers_are_multiples_of_a_step_below_one() {
    assert_eq!(from_reversed(u32::MAX), 1f32.next_down());
    assert_eq!(from_reversed(0), 0.0);
    for sample in 0..10_000 {
        let numbers = numbers_of(3, sample % 100, 17, sample);
        let pair = number_pair(numbers, sample % 7);
        assert_eq!(number(numbers, sample % 7), pair[0]);
        for value in pair {
            assert!((0.0..1.0).contains(&value));
            assert_eq!((value / STEP).fract(), 0.0);
        }
    }
}

/// How many standard deviations the mean of the products of two lists of numbers, less
/// their middle, is from 0.
fn correlation(a: &[f32], b: &[f32]) -> f64 {
    let products = a.iter().zip(b);
    let sum: f64 = products
        .map(|(a, b)| (f64::from(*a) - 0.5) * (f64::from(*b) - 0.5))
        .sum();
    sum / (VARIANCE * (a.len() as f64).sqrt())
}

fn column(points: &[[f32; 2]], at: usize) -> Vec<f32> {
    points.iter().map(|point| point[at]).collect()
}

#[test]
fn pairs_of_a_pixel_know_nothing_of_each_other() {
    let mut squares = 0.0;
    let mut count = 0.0;
    for pixel in PIXELS {
        for samples in [256, 1000] {
            for first in 0..6 {
                for second in first + 1..6 {
                    let [a, b] = [first, second].map(|pair| pairs(pixel, pair, 0..samples));
                    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                        let far = correlation(&column(&a, i), &column(&b, j));
                        assert!(
                            far.abs() < FAR * DEPENDENT.sqrt(),
                            "{pixel:?}: {first}, {second}: {far}"
                        );
                        squares += far * far;
                        count += 1.0;
                    }
                }
            }
        }
    }
    let variance: f64 = squares / count;
    println!("variance {variance}");
    assert!((1.0..DEPENDENT).contains(&variance), "{variance}");
    // The control: a pair and itself.
    let a = column(&pairs(PIXELS[0], 0, 0..256), 0);
    assert!(correlation(&a, &a) > FAR);
}

#[test]
fn pixels_know_nothing_of_each_other() {
    let size = 128;
    for sample in [0, 1, 5] {
        let values: Vec<[f32; 2]> = (0..size * size)
            .map(|i| number_pair(numbers_of(0, i % size, i / size, sample), 0))
            .collect();
        for at in 0..2 {
            let column = column(&values, at);
            let mean = column.iter().map(|v| f64::from(*v)).sum::<f64>() / column.len() as f64;
            let far = (mean - 0.5) / (VARIANCE / column.len() as f64).sqrt();
            assert!(far.abs() < FAR, "mean {mean}");
            for apart in [1, 2, size as usize, size as usize + 1] {
                let others = &column[apart..];
                let column = &column[..others.len()];
                let far = correlation(column, others);
                assert!(far.abs() < FAR, "{apart} apart: {far}");
                let same = column.iter().zip(others).filter(|(a, b)| a == b).count();
                // By chance, one in 2^24 would be.
                assert_eq!(same, 0, "{apart} apart");
            }
        }
    }
    // The means of a pixel's samples are far nearer than by chance: what the nets are for.
    // One in each of so many intervals varies by a part of the square of their width.
    let samples = 256;
    let near = (VARIANCE / f64::from(samples).powi(3)).sqrt();
    for pixel in PIXELS {
        for at in 0..2 {
            let values = column(&pairs(pixel, 0, 0..samples), at);
            let sum: f64 = values.iter().map(|v| f64::from(*v)).sum();
            let mean = sum / f64::from(samples);
            assert!((mean - 0.5).abs() < FAR * near, "{mean}");
        }
    }
}

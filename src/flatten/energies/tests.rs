//! The table against the integral, and the integral against directions that are drawn.

use super::*;
use crate::flat::Flat;
use crate::flatten::flatten;
use crate::kernel::glossy::{energy_of, place_of_energy};
use crate::kernel::microfacets::{lit_by_cosine, visible_normal};
use crate::kernel::mirror::mirrored;
use crate::kernel::vector::vec3;
use crate::random::Numbers;
use crate::scene::{Material, Scene};

/// Standard deviations that chance does not reach.
const FAR: f64 = 5.0;

/// The roughness that makes the least width, and others up to the largest.
const ROUGHNESSES: [f64; 8] = [0.03, 0.1, 0.2, 0.3, 0.5, 0.7, 0.85, 1.0];

fn flat_of(roughnesses: &[f64]) -> Flat<f32> {
    let material = |roughness: &f64| Material {
        mirror: [1.0; 3],
        roughness: *roughness,
        ..Material::default()
    };
    flatten(&Scene {
        materials: roughnesses.iter().map(material).collect(),
        ..Scene::default()
    })
}

#[test]
fn gauss_points_integrate_polynomials() {
    for count in POINTS {
        let points = gauss_points(count);
        for power in 0..2 * count as i32 {
            let sum: f64 = points.iter().map(|[x, w]| w * x.powi(power)).sum();
            let exact = 1.0 / f64::from(power + 1);
            assert!((sum - exact).abs() < 1e-14, "{count}, {power}: {sum}");
        }
        // The control: one power more.
        let power = 2 * count as i32;
        let sum: f64 = points.iter().map(|[x, w]| w * x.powi(power)).sum();
        assert!((sum - 1.0 / f64::from(power + 1)).abs() > 1e-20);
    }
}

/// The quadrature is right to some 1e-5, which four times as many points show.
#[test]
fn the_quadrature_converges() {
    let [usual, more] = [POINTS, POINTS.map(|count| 4 * count)].map(|p| p.map(gauss_points));
    let fewer = POINTS.map(|count| gauss_points(count / 3));
    let (mut worst, mut control): (f64, f64) = (0.0, 0.0);
    for roughness in ROUGHNESSES {
        let width = roughness * roughness;
        for place in 0..ENERGIES {
            let cosine = cosine_of_place(f64::from(place), width);
            let exact = energy(cosine, width, &more);
            worst = worst.max((energy(cosine, width, &usual) - exact).abs());
            control = control.max((energy(cosine, width, &fewer) - exact).abs());
        }
    }
    assert!(worst < 1e-5, "{worst:e}");
    assert!(control > 1e-4, "{control:e}");
}

/// What is drawn as a mirror scatters brings as much on average.
#[test]
fn drawn_directions_bring_the_energy() {
    let points = POINTS.map(gauss_points);
    let mut random = Numbers(9);
    let count = 200_000;
    for width in [1.0f32 / 1024.0, 0.09, 0.5, 1.0] {
        for cosine in [0.0005f32, 0.05, 0.3, 0.8, 1.0] {
            let view = vec3((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
            let (mut sum, mut squares) = (0.0, 0.0);
            for _ in 0..count {
                let pair = [0; 2].map(|_| random.between(0.0, 1.0) as f32);
                let light = mirrored(-view, visible_normal(view, width, pair));
                if light.z > 0.0 {
                    let part = f64::from(light.z * lit_by_cosine(view, light, width));
                    sum += part;
                    squares += part * part;
                }
            }
            let mean = sum / f64::from(count);
            let variance = (squares / f64::from(count) - mean * mean).max(0.0);
            let error = (variance / f64::from(count)).sqrt();
            let exact = energy(f64::from(cosine), f64::from(width), &points);
            // Besides, both have roundings: of f32, and of the quadrature.
            let most = FAR * error + 1e-5;
            assert!(
                (mean - exact).abs() < most,
                "{width}, {cosine}: {mean}, {exact}, {error:e}"
            );
        }
    }
}

/// Between the numbers of a row, the energy is off by 2^-11 of it at most.
#[test]
fn rows_are_fine_enough() {
    let points = POINTS.map(gauss_points);
    let flat = flat_of(&ROUGHNESSES);
    let (mut worst, mut coarse): (f64, f64) = (0.0, 0.0);
    for (finish, material) in flat.finishes.iter().zip(0..) {
        let width = f64::from(finish.width);
        let last = f64::from(ENERGIES - 1);
        let exact_at = |place| energy(cosine_of_place(place, width), width, &points);
        for quarter in 0..4 * (ENERGIES - 1) {
            let place = f64::from(quarter) / 4.0;
            let cosine = cosine_of_place(place, width).max(1e-6) as f32;
            let found = f64::from(energy_of(&flat, material, finish.width, cosine));
            let exact = energy(f64::from(cosine), width, &points);
            worst = worst.max((found / exact - 1.0).abs());
            // The control: every fourth number.
            let before = (place / 4.0).floor() * 4.0;
            let ends = [before, (before + 4.0).min(last)].map(exact_at);
            let part = (place - before) / (before + 4.0).min(last).max(before + 1.0);
            coarse = coarse.max(((ends[0] + (ends[1] - ends[0]) * part) / exact - 1.0).abs());
        }
    }
    println!("worst: {worst:e}");
    assert!(worst < 1.0 / 2048.0, "{worst:e}");
    assert!(coarse > 1.0 / 2048.0, "{coarse:e}");
}

#[test]
fn places_are_told_back() {
    for width in [1.0f32 / 1024.0, 0.25, 1.0] {
        for place in 0..ENERGIES {
            let cosine = cosine_of_place(f64::from(place), f64::from(width)) as f32;
            let back = f64::from(place_of_energy(cosine, width));
            // A handful of roundings of it.
            let most = 8.0 * f64::from(ENERGIES) / f64::from(1 << 24);
            assert!((back - f64::from(place)).abs() < most, "{place}: {back}");
        }
    }
}

/// Mirrors of one roughness share a row; what is smooth, or no mirror, has none.
#[test]
fn each_width_has_one_row() {
    let mut finishes = flat_of(&[0.0, 0.5, 0.3, 0.5]).finishes;
    finishes[2].mirror = [0.0; 3];
    let rows = energies(&mut finishes);
    assert_eq!(rows.len(), ENERGIES as usize);
    let flat = flat_of(&[0.0, 0.5, 0.3, 0.5, 0.01, 0.02]);
    assert_eq!(flat.energies.len(), 3 * ENERGIES as usize);
    let rows: Vec<u32> = flat.finishes.iter().map(|finish| finish.energies).collect();
    assert_eq!(rows, [0, 0, 1, 0, 2, 2]);
    // What grazes is thrown back whole; straight on, a rough one's small mirrors lose much.
    let row = &flat.energies[..ENERGIES as usize];
    assert!(row[0] == 1.0 && row[ENERGIES as usize - 1] < 0.95);
}

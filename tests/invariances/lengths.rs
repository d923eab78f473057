//! The length of a ray's direction: t is in parts of it.

use rayproof::accuracy::{BAND, Truths, Widths};
use rayproof::bounds::Bounds;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::found::Found;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::doubt::is_in_doubt;
use rayproof::kernel::hit::{Hit, no_hit};
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::trace::find_hit;
use rayproof::kernel::vector::Vec3;
use rayproof::layout::NO_HIT;
use rayproof::tier::Bounded;
use rayproof::{Accuracy, Backend, Unwatched};

use super::common::aimed::{aimed_rays, hard_scene};
use super::{TIERS, gpu_backend};

/// Bits of a direction's numbers: with those of a factor they fit into 24.
const BITS: i32 = 16;

/// Factors of at most 8 bits: nothing is rounded.
const FACTORS: [f32; 4] = [3.0, 11.0, 101.0, 255.0];

fn times(ray: Ray<f32>, factor: f32) -> Ray<f32> {
    Ray {
        direction: ray.direction * factor,
        ..ray
    }
}

/// Rays that are aimed where decisions are hard, of lengths near 1 and directions of 16 bits.
fn rays(flat: &Flat<f64>, count: usize) -> Vec<Ray<f32>> {
    let aimed = aimed_rays(flat, count, 21).into_iter();
    let tamed = aimed.map(|ray| {
        let numbers: [f32; 3] = ray.direction.into();
        let largest = numbers.iter().fold(0.0, |a: f32, b| a.max(b.abs()));
        let steps = 2f64.powi(BITS - 1) / 2f64.powi(f64::from(largest).log2().floor() as i32);
        let direction = numbers.map(|number| (f64::from(number) * steps).round() as f32);
        Ray {
            direction: Vec3::from(direction) * 2f32.powi(1 - BITS),
            ..ray
        }
    });
    tamed.collect()
}

fn found(widths: &Widths, backend: &Backend, accuracy: Accuracy, rays: &[Ray<f32>]) -> Vec<Found> {
    widths.trace_rays(backend, accuracy, rays).unwrap().0
}

/// Rays whose answer is not the same with t in parts of another length.
fn changed(one: &[Found], other: &[Found], factor: f64) -> usize {
    let pairs = one.iter().zip(other);
    let differing = pairs.filter(|(one, other)| one.id != other.id || one.t != other.t * factor);
    differing.count()
}

#[test]
fn a_power_of_two_scales_t_exactly() {
    let backends = [Backend::Cpu(None), gpu_backend()];
    for turned in [false, true] {
        let widths = Widths::of(flatten(&hard_scene(turned, 1.0)), Bounds::Tree);
        let rays = rays(&widths.double, 10_000);
        for accuracy in TIERS {
            let here = found(&widths, &backends[0], accuracy, &rays);
            assert!(here.iter().filter(|found| found.id != NO_HIT).count() > 4000);
            // Products of two f32 lose their rests sooner, see `two_float.rs`.
            let most = if accuracy == Accuracy::Extended {
                8
            } else {
                30
            };
            for exponent in [-most, -1, 1, most] {
                let factor = 2f32.powi(exponent);
                let longer: Vec<_> = rays.iter().map(|ray| times(*ray, factor)).collect();
                for backend in &backends {
                    let there = found(&widths, backend, accuracy, &longer);
                    let case = format!("{}, 2^{exponent}", accuracy.name());
                    assert_eq!(changed(&here, &there, factor.into()), 0, "{case}");
                }
            }
        }
        // The controls: a factor that rounds, and the textbook's fixed lengths.
        let cpu = &backends[0];
        let here = found(&widths, cpu, Accuracy::Robust, &rays);
        let longer: Vec<_> = rays.iter().map(|ray| times(*ray, 3.0)).collect();
        let there = found(&widths, cpu, Accuracy::Robust, &longer);
        assert!(changed(&here, &there, 3.0) > 1000);
        let shorter: Vec<_> = rays.iter().map(|ray| times(*ray, 2f32.powi(-30))).collect();
        let [here, there] =
            [&rays, &shorter].map(|rays| found(&widths, cpu, Accuracy::Textbook, rays));
        assert!(changed(&here, &there, 2f64.powi(-30)) > 1000);
    }
}

/// The hit, and the interval in which that of f64 lies.
fn bounded(flat: &Flat<Bounded>, ray: Ray<f32>) -> Hit<Bounded> {
    let mut hit = no_hit();
    find_hit(flat, probe_of(ray.converted()), &mut hit);
    hit
}

/// Any factor: the primitive is the same where a tier can tell, and t times the length is off
/// by no more than both intervals of the bounding formulas are wide; in f64 and two f32, by as
/// much less as their rounding is finer.
#[test]
fn any_factor_scales_t() {
    let backend = Backend::Cpu(None);
    let mut certain = 0;
    for turned in [false, true] {
        let widths = Widths::of(flatten(&hard_scene(turned, 1.0)), Bounds::Tree);
        let flat: Flat<Bounded> = widths.double.converted();
        let rays = rays(&widths.double, 5000);
        let exact: Vec<Ray<f64>> = rays.iter().map(|ray| ray.converted()).collect();
        // For the scene in f64, and for the scene as f32 has it.
        let mut rounded: Flat<f64> = widths.double.converted::<f32>().converted();
        rounded.take_powers_anew();
        let [fine, coarse] =
            [&widths.double, &rounded].map(|flat| Truths::of(flat, &exact, &Unwatched).unwrap().0);
        for factor in FACTORS {
            let longer: Vec<_> = rays.iter().map(|ray| times(*ray, factor)).collect();
            for accuracy in TIERS {
                let (truths, margin, part) = match accuracy {
                    Accuracy::Robust => (&coarse, BAND, 1.0),
                    Accuracy::Extended => (&fine, 1e-12, 15.0 * 2f64.powi(-24)),
                    Accuracy::Double => (&fine, 1e-12, 2f64.powi(-29)),
                    _ => (&fine, 1e-12, 1.0),
                };
                let [here, there] =
                    [&rays, &longer].map(|rays| found(&widths, &backend, accuracy, rays));
                for at in 0..rays.len() {
                    let case = || format!("{}, {factor}: {:?}", accuracy.name(), rays[at]);
                    if truths[at].margin > margin {
                        assert_eq!(here[at].id, there[at].id, "{}", case());
                    }
                    let hits = [rays[at], longer[at]].map(|ray| bounded(&flat, ray));
                    if hits.iter().any(|hit| is_in_doubt(*hit)) || here[at].id == NO_HIT {
                        continue;
                    }
                    certain += 1;
                    let [wide, wider] = hits.map(|hit| f64::from(hit.high.0 - hit.low.0));
                    let off = (here[at].t - there[at].t * f64::from(factor)).abs();
                    let most = part * (wide + wider * f64::from(factor));
                    assert!(off <= most, "{}: {off:e} of {most:e}", case());
                }
            }
        }
    }
    assert!(certain > 10_000, "{certain}");
}

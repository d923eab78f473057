//! Directions of an ordinary length, whatever that of the ray.

use crate::found::Found;
use crate::kernel::camera::Ray;

/// Exponents of the largest component, from and to which a direction is as it should be: its
/// square and a square of that, times a scene's lengths, neither overflow nor vanish.
const ORDINARY: std::ops::RangeInclusive<i32> = -8..=8;

/// The rays, with directions times a power of two where they are long or short, and the powers;
/// none if all are as they should be. A component is rounded only if it is 2^-126 of the
/// largest.
pub(super) fn ordinary(rays: &[Ray<f32>]) -> Option<(Vec<Ray<f32>>, Vec<f64>)> {
    let powers: Vec<f64> = rays.iter().map(power_of).collect();
    if powers.iter().all(|power| *power == 1.0) {
        return None;
    }
    let scaled = rays.iter().zip(&powers).map(|(ray, power)| {
        let direction = <[f32; 3]>::from(ray.direction);
        let direction = direction.map(|component| (f64::from(component) * power) as f32);
        Ray {
            direction: direction.into(),
            ..*ray
        }
    });
    Some((scaled.collect(), powers))
}

/// What the rays themselves find, given what they find with other directions.
pub(super) fn of_their_own(found: &mut [Found], powers: &[f64]) {
    for (found, power) in found.iter_mut().zip(powers) {
        found.t *= power;
    }
}

/// The power of two that makes the largest component one from 1 to 2, or 1.
fn power_of(ray: &Ray<f32>) -> f64 {
    let sizes = <[f32; 3]>::from(ray.direction).map(|component| f64::from(component.abs()));
    let largest = sizes.into_iter().fold(0.0, f64::max);
    if largest == 0.0 || !largest.is_finite() {
        return 1.0;
    }
    // Of an f64, a denormal f32 is a normal number.
    let exponent = (largest.to_bits() >> 52) as i32 - 1023;
    if ORDINARY.contains(&exponent) {
        return 1.0;
    }
    2f64.powi(-exponent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::vector::vec3;

    fn ray(x: f32, y: f32) -> Ray<f32> {
        Ray {
            origin: vec3(1.0, 2.0, 3.0),
            direction: vec3(x, y, 0.0),
        }
    }

    #[test]
    fn only_long_and_short_directions_change() {
        assert!(ordinary(&[ray(1.0, 300.0), ray(0.0, 0.01), ray(0.0, 0.0)]).is_none());
        let (rays, powers) = ordinary(&[ray(3e-40, 1e-40), ray(0.0, -3e30), ray(1.0, 1.0)])
            .expect("two of them are not ordinary");
        for (ray, power) in rays.iter().zip(&powers).take(2) {
            let sizes = <[f32; 3]>::from(ray.direction).map(f32::abs);
            let largest = sizes.into_iter().fold(0.0, f32::max);
            assert!((1.0..2.0).contains(&largest) && *power != 1.0);
        }
        assert_eq!(
            f64::from(rays[0].direction.x),
            f64::from(3e-40f32) * powers[0]
        );
        assert_eq!(powers[2], 1.0);
        let mut found = [Found::new(2.0, 7)];
        of_their_own(&mut found, &[0.25]);
        assert_eq!(found, [Found::new(0.5, 7)]);
    }
}

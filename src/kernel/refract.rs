//! Refraction: Snell's law.

use super::divide::square_root;
use super::mirror::mirrored;
use super::vector::{Vec3, dot_product, tame_vector, unit_vector};

/// The unit direction in which light goes on that comes in `direction` upon a surface whose
/// unit normal faces it; `ratio` is the index of refraction on this side by that beyond.
/// Where none goes through, all is thrown back.
///
/// By roundings a cosine may exceed 1, and the square of the other one fall below 0: the
/// first counts as 1, the second as a reflection. So no root is taken of a negative number.
pub fn refracted(direction: Vec3<f32>, normal: Vec3<f32>, ratio: f32) -> Vec3<f32> {
    let unit = unit_vector(tame_vector(direction));
    let along = -dot_product(unit, normal);
    let cosine = if along < 1.0 { along } else { 1.0 };
    let across = unit + normal * cosine;
    // The square of the ratio could overflow, and infinity times 0 is no number. And 1 less
    // the square of the cosine would lose a small sine.
    let sine_squared = ratio * (ratio * dot_product(across, across));
    if sine_squared > 1.0 {
        return unit_vector(mirrored(unit, normal));
    }
    let cosine_beyond = square_root(1.0 - sine_squared);
    unit_vector(tame_vector(across * ratio - normal * cosine_beyond))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::vector::{vec3, vector_length};

    const UP: Vec3<f32> = Vec3 {
        x: 0.0,
        y: 1.0,
        z: 0.0,
    };

    fn is_unit(v: Vec3<f32>) -> bool {
        // A sum of squares, a root and a quotient.
        (vector_length(v) - 1.0).abs() < 4.0 * f32::EPSILON
    }

    #[test]
    fn sines_are_as_the_ratio() {
        for ratio in [0.5, 2.0 / 3.0, 1.0, 1.25] {
            for length in [1e-30, 1.0, 1e30f32] {
                let direction = vec3(0.6, -0.8, 0.0) * length;
                let through = refracted(direction, UP, ratio);
                assert!(is_unit(through), "{through:?}");
                assert!(
                    (through.x - 0.6 * ratio).abs() < 1e-6,
                    "{ratio}: {through:?}"
                );
                assert!(through.y < 0.0);
            }
        }
        // The control: of more than 1 / 0.6 nothing goes through.
        let back = refracted(vec3(0.6, -0.8, 0.0), UP, 1.7);
        assert!(is_unit(back) && (back.y - 0.8).abs() < 1e-6, "{back:?}");
    }

    /// What a formula without the two comparisons gives.
    fn naive(unit: Vec3<f32>, ratio: f32) -> Vec3<f32> {
        let cosine = -unit.y;
        let beyond = (1.0 - ratio * ratio * (1.0 - cosine * cosine)).sqrt();
        unit * ratio + UP * (ratio * cosine - beyond)
    }

    #[test]
    fn nothing_but_numbers_comes_out_near_the_critical_angle() {
        let (mut thrown_back, mut not_a_number) = (0, 0);
        for ratio in [1.1f32, 1.5, 2.0, 1e10, 1e30] {
            let sine = 1.0 / ratio;
            let cosine = (1.0 - sine * sine).sqrt();
            for ulps in -3..=3 {
                let y = f32::from_bits(cosine.to_bits().wrapping_add_signed(ulps));
                let direction = vec3(sine, -y, 0.0);
                let out = refracted(direction, UP, ratio);
                assert!(is_unit(out), "{ratio}, {ulps}: {out:?}");
                thrown_back += usize::from(out.y > 0.0);
                not_a_number += usize::from(!naive(direction, ratio).y.is_finite());
            }
        }
        assert!(thrown_back > 0 && thrown_back < 35, "{thrown_back}");
        assert!(not_a_number > 0, "the control");
    }

    /// Straight on, by a normal that roundings made too long: the cosine exceeds 1.
    #[test]
    fn straight_on_is_straight_on() {
        let long = vec3(0.0, 1f32.next_up().next_up(), 0.0);
        for ratio in [0.25, 1.0, 4.0, 1e20] {
            let through = refracted(vec3(0.0, -2.0, 0.0), long, ratio);
            assert!(is_unit(through), "{ratio}: {through:?}");
        }
    }
}

//! How much of light a surface throws back, by the angle at which it is met.

use super::divide::{divide, square_root};
use super::vector::{Vec3, vec3};

/// What a clear surface throws back of unpolarised light, from 0 to 1: `cosine` is that of the
/// angle to its normal, from 0 to 1, and `ratio` the index of refraction on this side by that
/// beyond.
///
/// Fresnel's equations: Born, Wolf, "Principles of Optics", 7th edition, 1999, 1.5.2.
pub fn thrown_back(cosine: f32, ratio: f32) -> f32 {
    let here = ratio * cosine;
    // Of the cosine beyond, by a sum: 1 less the square of a sine would lose a small cosine.
    let square = (1.0 - ratio) * (1.0 + ratio) + here * here;
    // Nothing goes through; so a divisor below is never 0.
    if square <= 0.0 {
        return 1.0;
    }
    let beyond = square_root(square);
    let across = divide(here - beyond, here + beyond);
    let along = divide(cosine - ratio * beyond, cosine + ratio * beyond);
    (across * across + along * along) * 0.5
}

/// What a mirror throws back that throws back `straight` of light that meets it squarely: all
/// of what grazes it. `cosine` is from 0 to 1.
///
/// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Computer Graphics
/// Forum 13(3), 1994.
pub fn askew(straight: Vec3<f32>, cosine: f32) -> Vec3<f32> {
    let rest = 1.0 - cosine;
    let square = rest * rest;
    let part = (square * square) * rest;
    straight + (vec3(1.0, 1.0, 1.0) - straight) * part
}

#[cfg(test)]
mod tests;

//! A rough mirror as many small ones, by the distribution of their normals.
//!
//! Walter, Marschner, Li, Torrance, "Microfacet Models for Refraction through Rough Surfaces",
//! EGSR 2007: the distribution of Trowbridge and Reitz (GGX), of a width from 2^-10 to 1. Heitz,
//! "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014:
//! what of them is seen, and lit. Directions are unit vectors, told by axes of which the third
//! is the surface's normal.

use super::circle::circle_point;
use super::divide::{divide, square_root};
use super::vector::{Vec3, dot_product, unit_vector, vec3};

/// 1 / pi.
pub const INVERSE_PI: f32 = std::f32::consts::FRAC_1_PI;

/// The root in Smith's masking: that of cos^2 + (width sin)^2.
pub fn masking_root(cosine: f32, width: f32) -> f32 {
    let square = width * width;
    square_root(square + (1.0 - square) * (cosine * cosine))
}

/// pi times the density of normals in a direction of any length, by projected area and solid
/// angle. That the width stands beside the sine, not beside 1 less the square of the cosine, keeps
/// narrow lobes from what roundings leave of that.
pub fn density_of_normals(normal: Vec3<f32>, width: f32) -> f32 {
    let square = dot_product(normal, normal);
    let narrow = width * normal.z;
    let spread = (normal.x * normal.x + normal.y * normal.y) + narrow * narrow;
    let part = divide(width * square, spread);
    part * part
}

/// pi times the density, by solid angle, with which light that goes to `view` is drawn from
/// `light`, both above the surface: see [`visible_normal`].
pub fn shape_of_lobe(view: Vec3<f32>, light: Vec3<f32>, width: f32) -> f32 {
    let normals = density_of_normals(view + light, width);
    divide(normals, 2.0 * (view.z + masking_root(view.z, width)))
}

/// Of the small mirrors that are seen, the part that light from `light` comes to, over the
/// cosine of that: G2 / (G1 cos).
pub fn lit_by_cosine(view: Vec3<f32>, light: Vec3<f32>, width: f32) -> f32 {
    let seen = masking_root(view.z, width);
    let lit = masking_root(light.z, width);
    divide(view.z + seen, light.z * seen + view.z * lit)
}

/// The normal of one of the small mirrors that are seen from `view`, each as likely as it is
/// seen large.
///
/// Dupuy, Benyoub, "Sampling Visible GGX Normals with Spherical Caps", Computer Graphics Forum
/// 42(8), 2023.
pub fn visible_normal(view: Vec3<f32>, width: f32, pair: [f32; 2]) -> Vec3<f32> {
    let stretched = unit_vector(vec3(view.x * width, view.y * width, view.z));
    // How high the cap is, how high in it the point, and how far that is from both poles.
    let cap = 1.0 + stretched.z;
    let height = pair[1] * cap;
    let below = height + (1.0 - stretched.z);
    let above = (1.0 - pair[1]) * cap;
    let square = below * above;
    let radius = square_root(if square > 0.0 { square } else { 0.0 });
    let point = circle_point(pair[0]);
    let normal = vec3(
        (point[0] * radius + stretched.x) * width,
        (point[1] * radius + stretched.y) * width,
        height,
    );
    unit_vector(normal)
}

#[cfg(test)]
mod tests;

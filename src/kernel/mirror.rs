//! A mirror.

use super::hit::Surface;
use super::vector::{Vec3, dot_product};

/// The least cosine at which a surface counts as seen: some roundings of a unit vector.
pub const LEAST_COSINE: f32 = 1.0 / 1_048_576.0;

/// `direction` thrown back by a surface with this unit normal, of either side: as long as it
/// was.
pub fn mirrored(direction: Vec3<f32>, normal: Vec3<f32>) -> Vec3<f32> {
    direction - normal * (2.0 * dot_product(direction, normal))
}

/// The normal by which a surface mirrors: that of the shape itself where the smooth one is
/// turned away from the viewer, in whose direction `view` goes.
pub fn normal_to_viewer(surface: &Surface, view: Vec3<f32>) -> Vec3<f32> {
    if dot_product(surface.normal, view) > LEAST_COSINE {
        surface.normal
    } else {
        surface.facing
    }
}

/// The cosine of the angle between such a normal and the viewer: greater than 0, at most 1.
pub fn cosine_to_viewer(normal: Vec3<f32>, view: Vec3<f32>) -> f32 {
    let cosine = dot_product(normal, view);
    if cosine < LEAST_COSINE {
        return LEAST_COSINE;
    }
    if cosine < 1.0 { cosine } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::vector::vec3;

    #[test]
    fn a_mirror_turns_the_part_along_its_normal() {
        let direction = vec3(3.0, -5.0, 0.25);
        let up = vec3(0.0, 1.0, 0.0);
        assert_eq!(mirrored(direction, up), vec3(3.0, 5.0, 0.25));
        assert_eq!(mirrored(direction, -up), vec3(3.0, 5.0, 0.25));
        // 0.6 and 0.8 are off by half a rounding each.
        let turned = mirrored(vec3(1.0, 0.0, 0.0), vec3(0.6, 0.8, 0.0));
        let off = turned - vec3(0.28, -0.96, 0.0);
        assert!(off.x.abs() < 1e-6 && off.y.abs() < 1e-6 && off.z == 0.0);
    }
}

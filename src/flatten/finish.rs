//! What only pictures of many samples read: how surfaces answer light besides their albedo,
//! and how paths are sampled.

use super::color;
use crate::layout::{FinishRecord, FogRecord, NONE, ONLY_LIGHTS, ONLY_SURFACES, SamplingRecord};
use crate::scene::{Material, Scene, Strategy};

/// How a material answers light besides its albedo.
pub(super) fn finish(material: &Material) -> FinishRecord {
    FinishRecord {
        mirror: color(material.mirror),
        width: width(material.roughness),
        emission: color(material.emission),
        ior: material.ior.unwrap_or(0.0) as f32,
        absorption: color(material.absorption),
        lamp: NONE,
        texture: NONE,
        is_cutout: u32::from(material.cutout),
        energies: 0,
        padding: 0,
    }
}

/// The least width of a mirror that is not smooth. Directions are off by some 2^-22, which is
/// 2^-12 of it, so that densities are off by 2^-11; and the lobe, of four times the width as an
/// angle, is but two pixels of 640 by which 60 degrees are seen.
const LEAST_WIDTH: f64 = 1.0 / 1024.0;

/// The width of the small mirrors' distribution; 0 where the mirror is smooth.
fn width(roughness: f64) -> f32 {
    if roughness == 0.0 {
        return 0.0;
    }
    (roughness * roughness).max(LEAST_WIDTH) as f32
}

/// How a scene is sampled.
pub(super) fn sampling(scene: &Scene) -> SamplingRecord {
    let integrator = &scene.integrator;
    // Where nothing is mirrored or clear, no path is.
    let is_bent = |material: &Material| material.mirror != [0.0; 3] || material.ior.is_some();
    let reflects = scene.materials.iter().any(is_bent);
    SamplingRecord {
        seed: integrator.seed,
        bounces: integrator.bounces,
        reflections: if reflects { integrator.reflections } else { 0 },
        strategy: match integrator.strategy {
            Strategy::Both => 0,
            Strategy::Lights => ONLY_LIGHTS,
            Strategy::Surfaces => ONLY_SURFACES,
        },
        spread: if integrator.samples > 1 { 1.0 } else { 0.0 },
        occlusion: scene.occlusion as f32,
        ..SamplingRecord::default()
    }
}

/// The fog, or one that takes nothing out of light.
pub(super) fn fog(scene: &Scene) -> FogRecord {
    scene.fog.map_or_else(FogRecord::default, |fog| FogRecord {
        albedo: color(fog.albedo),
        density: fog.density as f32,
    })
}

//! How what calls for an effect is taken out of a scene.

use std::sync::Arc;

use glam::DVec3;

use super::Part;
use super::set::named;
use crate::error::{Error, Result};
use crate::scene::{Geometry, Light, Mesh, Scene};

/// The scene without what calls for the effect of this name.
///
/// # Errors
///
/// [`Error::Usage`] for a name that no effect has, for shapes, and for volumes, which the
/// settings ask for.
pub fn without(scene: &Scene, name: &str) -> Result<Scene> {
    let effect = named(name)?;
    let Some(remove) = effect.removal else {
        let reason = match effect.part {
            Part::Bounds | Part::Screen => "`--bounds` chooses the volumes",
            _ => "it comes with the scene's shapes",
        };
        return Err(Error::Usage(format!(
            "`{name}` cannot be left out: {reason}"
        )));
    };
    let mut left = scene.clone();
    remove(&mut left);
    Ok(left)
}

pub(super) fn smooth_normals(scene: &mut Scene) {
    for shape in &mut scene.shapes {
        if let Geometry::Mesh(mesh) = &mut shape.geometry {
            *mesh = Arc::new(Mesh {
                normals: Vec::new(),
                triangle_normals: Vec::new(),
                ..Mesh::clone(mesh)
            });
        }
    }
}

pub(super) fn point_lights(scene: &mut Scene) {
    keep_lights(scene, |light| !matches!(light, Light::Point { .. }));
}

pub(super) fn directional_lights(scene: &mut Scene) {
    keep_lights(scene, |light| !matches!(light, Light::Directional { .. }));
}

pub(super) fn soft_shadows(scene: &mut Scene) {
    keep_lights(scene, |light| !matches!(light, Light::Area { .. }));
}

pub(super) fn hard_shadows(scene: &mut Scene) {
    for light in &mut scene.lights {
        match light {
            Light::Point { shadow, .. } | Light::Directional { shadow, .. } => *shadow = false,
            Light::Area { .. } => {}
        }
    }
}

pub(super) fn mirrors(scene: &mut Scene) {
    for material in &mut scene.materials {
        (material.mirror, material.roughness) = ([0.0; 3], 0.0);
    }
}

pub(super) fn glossy_reflection(scene: &mut Scene) {
    for material in &mut scene.materials {
        material.roughness = 0.0;
    }
}

pub(super) fn refraction(scene: &mut Scene) {
    for material in &mut scene.materials {
        (material.ior, material.absorption) = (None, [0.0; 3]);
    }
}

pub(super) fn textures(scene: &mut Scene) {
    for material in &mut scene.materials {
        (material.texture, material.cutout) = (None, false);
    }
}

pub(super) fn cutouts(scene: &mut Scene) {
    for material in &mut scene.materials {
        material.cutout = false;
    }
}

/// Lamps shine too, so they go with it.
pub(super) fn emission(scene: &mut Scene) {
    for material in &mut scene.materials {
        material.emission = [0.0; 3];
    }
    soft_shadows(scene);
}

pub(super) fn environment(scene: &mut Scene) {
    scene.environment = None;
}

pub(super) fn depth_of_field(scene: &mut Scene) {
    scene.camera.aperture = 0.0;
}

pub(super) fn motion_blur(scene: &mut Scene) {
    scene.camera.velocity = DVec3::ZERO;
    for shape in &mut scene.shapes {
        shape.velocity = DVec3::ZERO;
    }
}

pub(super) fn fog(scene: &mut Scene) {
    scene.fog = None;
}

pub(super) fn ambient_occlusion(scene: &mut Scene) {
    scene.occlusion = 0.0;
}

pub(super) fn indirect_light(scene: &mut Scene) {
    scene.integrator.bounces = 0;
}

pub(super) fn anti_aliasing(scene: &mut Scene) {
    scene.integrator.samples = 1;
}

/// The lights that are kept, with their origins.
fn keep_lights(scene: &mut Scene, is_kept: impl Fn(&Light) -> bool) {
    let kept: Vec<bool> = scene.lights.iter().map(is_kept).collect();
    let mut of_light = kept.iter();
    scene.lights.retain(|_| of_light.next() == Some(&true));
    let mut of_origin = kept.iter();
    scene
        .origins
        .lights
        .retain(|_| of_origin.next() == Some(&true));
}

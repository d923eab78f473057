//! What is allowed, but hardly meant.

use crate::scene::{Environment, Light, Material, Scene, Sky};

/// A warning for each oddity.
pub(super) fn oddities(scene: &Scene, name: &str) -> Vec<String> {
    let mut oddities = Vec::new();
    let mut odd = |what: &str| oddities.push(format!("{name}: {what}"));
    if scene.shapes.is_empty() {
        odd("no shapes, the picture shows the background; add [[sphere]] or another");
    }
    if is_black(scene) {
        odd("no light and no ambient light, every shape is black; add [[light]] or [ambient]");
    }
    if scene.camera.focus.is_some() && scene.camera.aperture == 0.0 {
        odd("`focus` without `aperture`: a pinhole shows everything sharp; add `aperture`");
    }
    if scene.fog.is_some() {
        let far = |light: &Light| matches!(light, Light::Directional { .. });
        if scene.lights.iter().any(far) {
            odd(
                "a directional light and [fog]: nothing comes through fog that has no end; \
                 use a light at a place",
            );
        }
        if scene.environment.is_some() {
            odd("[environment] and [fog]: nothing comes through fog that has no end");
        }
    }
    oddities
}

/// Does nothing shine, and shows no shape what is behind or before it?
fn is_black(scene: &Scene) -> bool {
    let black = [0.0; 3];
    let is_dark = |light: &Light| match light {
        Light::Point { color, .. }
        | Light::Directional { color, .. }
        | Light::Area {
            radiance: color, ..
        } => *color == black,
    };
    let is_matt = |material: &Material| {
        material.emission == black && material.mirror == black && material.ior.is_none()
    };
    scene.ambient == black
        && scene.lights.iter().all(is_dark)
        && scene.environment.as_ref().is_none_or(shines_not)
        && scene.materials.iter().all(is_matt)
}

fn shines_not(environment: &Environment) -> bool {
    let dark = match &environment.sky {
        Sky::Gradient(ramp) => ramp.from == [0.0; 3] && ramp.to == [0.0; 3],
        Sky::Image(image) => image.texels.iter().all(|[r, g, b, _]| r + g + b == 0.0),
    };
    dark || environment.intensity == 0.0
}

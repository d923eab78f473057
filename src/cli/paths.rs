//! What users are told of scenes whose pictures are made of paths of light.

use rayproof::effects::path_effects_of;
use rayproof::render::Stats;
use rayproof::scene::Scene;

/// Warns where a scene calls for paths of light and something is done to the camera's rays
/// alone; `does` says what, such as "`bench` times".
pub(super) fn warn_of_paths(scene: &Scene, does: &str) {
    let effects = path_effects_of(scene);
    if !effects.is_empty() {
        tracing::warn!(
            "the scene calls for paths of light ({}): {does} the camera's rays alone, \
             one a pixel",
            effects.join(", ")
        );
    }
}

/// What a pixel is made of: its one ray, or so many paths.
pub(super) fn a_pixel_of(paths: bool, samples: u32) -> String {
    match (paths, samples) {
        (false, _) => "one ray a pixel".into(),
        (true, 1) => "one path a pixel".into(),
        (true, samples) => format!("{samples} paths a pixel"),
    }
}

/// Says so where samples were left out.
pub(super) fn warn_of_faults(stats: &Stats) {
    if let Some([x, y]) = stats.first_fault {
        tracing::warn!(
            "{} samples were infinite or not a number, or took more steps than the driver \
             allows, and are left out; \
             the first one is in pixel ({x}, {y})",
            stats.faults
        );
    }
}

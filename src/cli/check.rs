//! `rayproof check`.

use serde::Serialize;

use super::Outcome;
use super::faults::Faulty;
use super::flags::{CheckArguments, Common};
use super::paths::a_pixel_of;
use super::report::{self, table};
use rayproof::bounds::overfull_groups;
use rayproof::effects::{EffectSet, effects_of, takes_samples};
use rayproof::error::Result;
use rayproof::flatten::flatten;
use rayproof::plan::{PATHS, traced};
use rayproof::scene::parse::Note;

/// What is in a scene.
#[derive(Serialize)]
struct Contents {
    scene: String,
    width: u32,
    height: u32,
    samples: u32,
    traced: &'static str,
    spheres: usize,
    planes: usize,
    disks: usize,
    triangles: usize,
    lights: usize,
    materials: usize,
    effects: Vec<&'static str>,
    device_bytes: u64,
    warnings: Vec<String>,
    notes: Vec<Note>,
    /// None, so that scripts may look here whatever the outcome.
    faults: [(); 0],
}

/// Loads a scene with everything it refers to, and says what is in it. Its
/// faults, if it has any, come back as the error, and as records with `--json`.
pub(super) fn run(arguments: &CheckArguments, common: &Common) -> Result<Outcome> {
    let name = arguments.scene.display().to_string();
    let loaded = match arguments.policy.load(&arguments.scene) {
        Ok(loaded) => loaded,
        Err(error) => {
            if let Some(faulty) = Faulty::of(name, &error).filter(|_| common.json) {
                report::print(&report::json(&faulty))?;
            }
            return Err(error);
        }
    };
    let mut warnings = loaded.warnings;
    warnings.extend(overfull_groups(&loaded.scene));
    let flat = flatten::<f32>(&loaded.scene);
    let counts = flat.counts();
    let contents = Contents {
        scene: name,
        width: flat.size[0],
        height: flat.size[1],
        samples: loaded.scene.integrator.samples,
        traced: traced(&counts, EffectSet::NONE),
        spheres: flat.spheres.len(),
        planes: flat.planes.len(),
        disks: flat.disks.len(),
        triangles: flat.triangles.len(),
        lights: loaded.scene.lights.len(),
        materials: loaded.scene.materials.len(),
        effects: effects_of(&counts, takes_samples(&counts, EffectSet::NONE)),
        device_bytes: flat.bytes(),
        warnings,
        notes: loaded.notes,
        faults: [],
    };
    if common.json {
        report::print(&report::json(&contents))?;
        return Ok(Outcome::Done);
    }
    for warning in &contents.warnings {
        tracing::warn!("{warning}");
    }
    if !common.quiet {
        report::print(&summary(&contents))?;
    }
    Ok(Outcome::Done)
}

fn summary(contents: &Contents) -> String {
    let mut rows = vec![
        ("scene", format!("{}: no faults", contents.scene)),
        (
            "picture",
            format!(
                "{} x {}, {}",
                contents.width,
                contents.height,
                a_pixel_of(contents.traced == PATHS, contents.samples)
            ),
        ),
        (
            "shapes",
            format!(
                "{} spheres, {} planes, {} disks, {} triangles",
                contents.spheres, contents.planes, contents.disks, contents.triangles
            ),
        ),
        ("lights", contents.lights.to_string()),
        ("effects", contents.effects.join(", ")),
        (
            "memory",
            format!(
                "{:.1} MiB on the device",
                contents.device_bytes as f64 / 1_048_576.0
            ),
        ),
    ];
    for Note { line, message } in &contents.notes {
        rows.push(("note", format!("{}:{line}: {message}", contents.scene)));
    }
    table(&rows)
}

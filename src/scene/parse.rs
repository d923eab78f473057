//! Scene files: TOML to [`Scene`], with every fault told in one run, each at its
//! line and column. `docs/scene-format.md` describes the format.

mod asset;
mod expand;
mod faults;
mod file;
mod group;
mod material;
mod near;
mod notes;
mod placement;
mod section;
mod settings;
mod shape;
mod syntax;
mod value;

use std::path::Path;

use toml::de::DeTable;

use self::faults::Faults;
use self::material::Palette;
pub use self::notes::Note;
use self::section::Section;
use self::syntax::SyntaxError;
use super::{Light, Scene, check, policy::Policy};
use crate::Result;

/// A scene, and what was odd about its file without being wrong.
#[derive(Debug, Clone)]
pub struct Loaded {
    /// The scene; it passes [`Scene::validate`].
    pub scene: Scene,
    /// One line each, for people.
    pub warnings: Vec<String>,
    /// What f32 cannot tell of it.
    pub notes: Vec<Note>,
}

impl Scene {
    /// Loads a scene file under the default [`Policy`] and logs its warnings.
    ///
    /// # Errors
    ///
    /// Those of [`load`].
    pub fn load(path: impl AsRef<Path>) -> Result<Scene> {
        let loaded = load(path.as_ref(), &Policy::default())?;
        for warning in &loaded.warnings {
            tracing::warn!("{warning}");
        }
        Ok(loaded.scene)
    }
}

/// Loads a scene file; mesh files are looked for in its folder.
///
/// # Errors
///
/// [`Error::Asset`](crate::Error::Asset) where the file cannot be read as text, [`Error::Scene`](crate::Error::Scene) with
/// all the faults of the file and of the meshes it refers to.
pub fn load(path: &Path, policy: &Policy) -> Result<Loaded> {
    let text = file::read(path, policy.max_scene_bytes)?;
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    parse_str(&text, &path.display().to_string(), folder, policy)
}

/// Reads the text of a scene. `name` stands for the file in messages, `folder`
/// is where mesh files are looked for.
///
/// # Errors
///
/// [`Error::Scene`](crate::Error::Scene) with all the faults of the text and of the meshes it refers
/// to.
pub fn parse_str(text: &str, name: &str, folder: &Path, policy: &Policy) -> Result<Loaded> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let readable;
    let (table, mut faults) = match DeTable::parse(text) {
        Ok(table) => (table, Faults::new(text, Vec::new(), Vec::new())),
        Err(_) => {
            readable = syntax::readable(text);
            let (table, left) = DeTable::parse_recoverable(&readable.text);
            let mut errors = readable.errors;
            errors.extend(left.into_iter().map(SyntaxError::from));
            (table, Faults::new(text, errors, readable.broken))
        }
    };
    match read(text, table.get_ref(), folder, policy, &mut faults) {
        Some(mut loaded) if faults.is_empty() => {
            loaded.warnings.extend(oddities(&loaded.scene, name));
            Ok(loaded)
        }
        _ => Err(faults.into_error(name)),
    }
}

fn read(
    text: &str,
    table: &DeTable<'_>,
    folder: &Path,
    policy: &Policy,
    faults: &mut Faults<'_>,
) -> Option<Loaded> {
    let mut root = Section::new("the scene file", 0..0, table);
    let image = settings::image(root.table("image", "[image]", faults), faults);
    if !root.has("camera") && !faults.hides_camera {
        let help = "add [camera] with `eye` and `target`";
        faults.push(0..0, "the scene has no [camera]", "no [camera]", help);
    }
    let camera = root.table("camera", "[camera]", faults);
    let camera = camera.and_then(|section| settings::camera(section, faults));
    let background = settings::background(root.table("background", "[background]", faults), faults);
    let ambient = settings::ambient(root.table("ambient", "[ambient]", faults), faults);
    let lights = root.tables("light", "[[light]]", faults);
    if let Some(surplus) = lights.get(check::MAX_LIGHTS) {
        faults.judge(surplus.span.clone(), check::light_count(lights.len()));
    }
    let lights = lights
        .into_iter()
        .filter_map(|section| settings::light(section, faults))
        .collect();
    let mut palette = Palette::default();
    for section in root.tables("material", "[[material]]", faults) {
        palette.read(section, faults);
    }
    let contents = group::Contents::read(&mut root, &palette, faults);
    root.close(faults);

    let expanded = expand::expand(contents, palette, folder, policy, faults)?;
    let scene = Scene {
        image,
        camera: camera?,
        background,
        ambient,
        lights,
        materials: expanded.materials,
        shapes: expanded.shapes,
        groups: expanded.groups,
        ..Scene::default()
    };
    Some(Loaded {
        notes: notes::notes(text, &scene, &expanded.origins),
        scene,
        warnings: expanded.warnings,
    })
}

/// What is allowed, but hardly meant.
fn oddities(scene: &Scene, name: &str) -> Vec<String> {
    let mut oddities = Vec::new();
    if scene.shapes.is_empty() {
        oddities.push(format!(
            "{name}: no shapes, the picture shows the background; add [[sphere]] or another"
        ));
    }
    let dark = |light: &Light| match light {
        Light::Point { color, .. }
        | Light::Directional { color, .. }
        | Light::Area {
            radiance: color, ..
        } => *color == [0.0; 3],
    };
    if scene.ambient == [0.0; 3] && scene.lights.iter().all(dark) {
        oddities.push(format!(
            "{name}: no light and no ambient light, every shape is black; add [[light]] or [ambient]"
        ));
    }
    oddities
}

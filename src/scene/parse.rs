//! Scene files: TOML to [`Scene`], with every fault told in one run, each at its
//! line and column. `docs/scene-format.md` describes the format.

mod asset;
mod expand;
mod faults;
mod file;
mod group;
mod image_file;
mod light;
mod lines;
mod material;
mod near;
mod notes;
mod oddities;
mod placement;
mod section;
mod settings;
mod shape;
mod surface;
mod surroundings;
mod syntax;
mod value;

use std::path::Path;

use toml::de::DeTable;

use self::asset::Library;
use self::faults::Faults;
use self::image_file::ImageFiles;
use self::material::Palette;
pub use self::notes::Note;
use self::section::Section;
use self::syntax::SyntaxError;
use super::{Light, Origin, Origins, Scene, check, policy::Policy};
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
    match read(table.get_ref(), folder, policy, &mut faults) {
        Some(mut loaded) if faults.is_empty() => {
            loaded
                .warnings
                .extend(oddities::oddities(&loaded.scene, name));
            Ok(loaded)
        }
        _ => Err(faults.into_error(name)),
    }
}

fn read(
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
    let mut origins = Origins::default();
    let mut section = |key, title, origin: &mut Origin, faults: &mut Faults<'_>| {
        let section = root.table(key, title, faults)?;
        origin.line = Some(faults.line_of(&section.span));
        Some(section)
    };
    let camera = section("camera", "[camera]", &mut origins.camera, faults);
    let camera = camera.and_then(|section| settings::camera(section, faults));
    let integrator = section(
        "integrator",
        "[integrator]",
        &mut origins.integrator,
        faults,
    );
    let integrator = settings::integrator(integrator, faults);
    let background = section("background", "[background]", &mut Origin::default(), faults);
    let both = background.is_some();
    let background = surroundings::background(background, faults);
    let mut images = ImageFiles::new(folder, policy);
    let around = section(
        "environment",
        "[environment]",
        &mut origins.environment,
        faults,
    );
    if let Some(around) = around.as_ref().filter(|_| both) {
        let message = "the scene has both a [background] and an [environment]";
        let help = "keep [environment], which is seen too, or [background], which lights nothing";
        faults.push(around.span.clone(), message, "a second one", help);
    }
    let environment = surroundings::environment(around, &mut images, faults);
    let fog = section("fog", "[fog]", &mut origins.fog, faults);
    let fog = surroundings::fog(fog, faults);
    let ambient = section("ambient", "[ambient]", &mut origins.ambient, faults);
    let (ambient, occlusion) = surroundings::ambient(ambient, faults);
    let lights = lights(&mut root, &mut origins.lights, faults);
    let mut palette = Palette::default();
    for section in root.tables("material", "[[material]]", faults) {
        palette.read(section, &mut images, faults);
    }
    let contents = group::Contents::read(&mut root, &palette, faults);
    root.close(faults);

    let library = Library::new(folder, policy, images.into_images());
    let expanded = expand::expand(contents, palette, library, faults)?;
    origins.materials = expanded.material_origins;
    origins.shapes = expanded.origins;
    let scene = Scene {
        image,
        camera: camera?,
        background,
        environment,
        fog,
        ambient,
        occlusion,
        integrator,
        lights,
        materials: expanded.materials,
        shapes: expanded.shapes,
        groups: expanded.groups,
        origins,
    };
    Some(Loaded {
        notes: notes::notes(&scene),
        scene,
        warnings: expanded.warnings,
    })
}

/// All lights, and where they stand.
fn lights(
    root: &mut Section<'_, '_>,
    origins: &mut Vec<Origin>,
    faults: &mut Faults<'_>,
) -> Vec<Light> {
    let sections = root.tables("light", "[[light]]", faults);
    if let Some(surplus) = sections.get(check::MAX_LIGHTS) {
        faults.judge(surplus.span.clone(), check::light_count(sections.len()));
    }
    let mut lights = Vec::new();
    for section in sections {
        let line = Some(faults.line_of(&section.span));
        if let Some((light, name)) = light::light(section, faults) {
            lights.push(light);
            origins.push(Origin { name, line });
        }
    }
    lights
}

//! The materials that faces name, from MTL files and the images that these name.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use super::elements::{NO_MATERIAL, Notes};
use super::library::{Described, load_library};
use super::map::Map;
use super::read::Fault;
use crate::error::{Error, Result};
use crate::scene::guard::{Guard, Refusal};
use crate::scene::texels::Images;
use crate::scene::{Material, Pattern, Rgb, Texture, check};

/// The albedo of a material that no file describes; many programs write it for
/// a surface that nobody gave a colour.
const DEFAULT_ALBEDO: Rgb = [0.8; 3];

/// The name of the material of faces that name none.
const DEFAULT_NAME: &str = "default";

/// More MTL files in one OBJ file are refused: each may cost a look at the
/// disk and a warning, and honest files name one.
const MAX_LIBRARIES: usize = 64;

/// The length of one repeat where a face has no texture coordinates.
const TEXTURE_SIZE: f64 = 1.0;

/// What the reader of materials may use and must keep to.
pub(super) struct Sources<'a> {
    pub guard: &'a Guard,
    /// Of all MTL files together.
    pub max_bytes: u64,
    pub images: &'a mut Images,
}

/// A material as described, and the file that does it.
type Libraries = HashMap<String, (Described, PathBuf)>;

/// The materials that the faces name, those of [`Notes::names`], and
/// one more if faces without a material come among them.
pub(super) fn resolve(
    obj: &Path,
    sources: Sources<'_>,
    notes: &Notes,
    warnings: &mut Vec<String>,
) -> Result<Vec<Material>> {
    let described = load_libraries(obj, &sources, notes, warnings)?;
    let mut undefined = notes
        .names
        .iter()
        .filter(|&name| !described.contains_key(name));
    if let Some(first) = undefined.next() {
        warnings.push(match undefined.count() {
            0 => format!("material `{first}` is defined nowhere: taken as grey"),
            more => format!(
                "{} materials are defined nowhere: taken as grey (the first is `{first}`)",
                more + 1
            ),
        });
    }
    let grey = |name: &str| Material {
        name: name.to_string(),
        albedo: DEFAULT_ALBEDO,
        ..Material::default()
    };
    let mut materials = Vec::new();
    for name in &notes.names {
        materials.push(match described.get(name) {
            Some((described, path)) => Material {
                name: name.clone(),
                ..material(described, path, sources.images, warnings)?
            },
            None => grey(name),
        });
    }
    let some_name_none = notes.faces.iter().any(|face| face.material == NO_MATERIAL);
    if some_name_none && !notes.names.is_empty() {
        materials.push(grey(DEFAULT_NAME));
    }
    Ok(materials)
}

/// A material that the MTL file at `path` describes.
fn material(
    described: &Described,
    path: &Path,
    images: &mut Images,
    warnings: &mut Vec<String>,
) -> Result<Material> {
    let texture = described.texture.as_ref();
    let unchanged = if texture.is_some() {
        [1.0; 3]
    } else {
        DEFAULT_ALBEDO
    };
    let same_file = |holes: &&Map| texture.is_some_and(|texture| texture.file == holes.file);
    let holes = described.holes.as_ref();
    if let Some(other) = holes.filter(|holes| !same_file(holes)) {
        warnings.push(format!(
            "{}: map_d (line {}) not applied: it must name the image of map_Kd, whose alpha counts",
            path.display(),
            other.line
        ));
    }
    Ok(Material {
        albedo: described.albedo.unwrap_or(unchanged),
        emission: described.emission,
        texture: texture.map(|map| image(map, path, images)).transpose()?,
        cutout: holes.is_some_and(|holes| same_file(&holes)),
        ..Material::default()
    })
}

fn image(map: &Map, path: &Path, images: &mut Images) -> Result<Texture> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let file = folder.join(&map.file);
    let fault = |message| Fault::at(map.line, format!("map_Kd: {message}")).into_error(path);
    let image = images.image(&file).map_err(|error| match error {
        Error::Asset { .. } => fault(error.to_string()),
        other => other,
    })?;
    check::brightest_texel(image.largest)
        .map_err(|flaw| fault(flaw.at(&file.display().to_string()).message))?;
    Ok(Texture {
        pattern: Pattern::Image(image.texels),
        repeat: map.repeat,
        size: TEXTURE_SIZE,
    })
}

/// All materials of all MTL files; where a name comes twice, the last counts.
fn load_libraries(
    obj: &Path,
    sources: &Sources<'_>,
    notes: &Notes,
    warnings: &mut Vec<String>,
) -> Result<Libraries> {
    let folder = obj.parent().unwrap_or(Path::new(""));
    let mut budget = sources.max_bytes;
    let mut seen: Vec<PathBuf> = Vec::new();
    let mut described = Libraries::new();
    for (rest, line) in &notes.libraries {
        for file_name in file_names(rest) {
            let path = folder.join(file_name);
            if seen.contains(&path) {
                continue;
            }
            if seen.len() == MAX_LIBRARIES {
                let message = format!("more than {MAX_LIBRARIES} MTL files");
                return Err(Fault::at(*line, message).into_error(obj));
            }
            match sources.guard.open(&path, budget) {
                Ok(file) => {
                    let (materials, bytes) = load_library(file, &path, warnings)
                        .map_err(|fault| fault.into_error(&path))?;
                    let placed = |(name, material)| (name, (material, path.clone()));
                    described.extend(materials.into_iter().map(placed));
                    budget = budget.saturating_sub(bytes);
                }
                Err(Refusal::Missing) => warnings.push(format!(
                    "no MTL file `{}` (line {line}): its materials are taken as grey",
                    path.display()
                )),
                Err(Refusal::Refused(message)) => {
                    return Err(Fault::at(*line, format!("mtllib: {message}")).into_error(obj));
                }
            }
            seen.push(path);
        }
    }
    Ok(described)
}

/// `mtllib` may name several files, and names may have spaces in them: a name
/// ends with a word that ends in `.mtl`, or with the line.
fn file_names(rest: &str) -> Vec<&str> {
    let mut names = Vec::new();
    let mut start = 0;
    for word in rest.split_whitespace() {
        // The distance between two parts of one string.
        let end = word.as_ptr() as usize - rest.as_ptr() as usize + word.len();
        let suffix = word.len().checked_sub(4).and_then(|at| word.get(at..));
        if suffix.is_some_and(|suffix| suffix.eq_ignore_ascii_case(".mtl")) {
            names.push(rest[start..end].trim());
            start = end;
        }
    }
    names.push(rest[start..].trim());
    names.retain(|name| !name.is_empty());
    names
}

#[cfg(test)]
mod tests {
    use super::file_names;

    #[test]
    fn several_files_and_spaces_in_names() {
        assert_eq!(file_names("a.mtl"), ["a.mtl"]);
        assert_eq!(file_names("a.mtl  b.MTL"), ["a.mtl", "b.MTL"]);
        assert_eq!(file_names("my  own.mtl b.mtl"), ["my  own.mtl", "b.mtl"]);
        assert_eq!(file_names("colours of it"), ["colours of it"]);
        assert_eq!(file_names("a.mtl rest"), ["a.mtl", "rest"]);
        assert!(file_names("").is_empty());
    }
}

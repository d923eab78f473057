//! MTL files: the diffuse colour (`Kd`) of each material that faces use.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use super::elements::{NO_MATERIAL, Notes, name, statement};
use super::feed::{Feed, Translate};
use super::read::Fault;
use super::tally::Tally;
use crate::error::Result;
use crate::scene::guard::{Capped, Guard, Refusal};
use crate::scene::{Material, Rgb};

/// The albedo of a material that no file describes; many programs write it for
/// a surface that nobody gave a colour.
const DEFAULT_ALBEDO: Rgb = [0.8; 3];

/// The name of the material of faces that name none.
const DEFAULT_NAME: &str = "default";

/// More MTL files in one OBJ file are refused: each may cost a look at the
/// disk and a warning, and honest files name one.
const MAX_LIBRARIES: usize = 64;

/// The materials that the faces name; [`Notes::names`] with their albedos, and
/// one more if faces without a material come among them.
pub(super) fn resolve(
    obj: &Path,
    guard: &Guard,
    max_bytes: u64,
    notes: &Notes,
    warnings: &mut Vec<String>,
) -> Result<Vec<Material>> {
    let albedos = load_libraries(obj, guard, max_bytes, notes, warnings)?;
    let mut undefined = notes
        .names
        .iter()
        .filter(|&name| !albedos.contains_key(name));
    if let Some(first) = undefined.next() {
        warnings.push(match undefined.count() {
            0 => format!("material `{first}` is defined nowhere: taken as grey"),
            more => format!(
                "{} materials are defined nowhere: taken as grey (the first is `{first}`)",
                more + 1
            ),
        });
    }
    let mut materials: Vec<_> = notes
        .names
        .iter()
        .map(|name| Material {
            name: name.clone(),
            albedo: albedos.get(name).copied().unwrap_or(DEFAULT_ALBEDO),
            ..Material::default()
        })
        .collect();
    let some_name_none = notes.faces.iter().any(|face| face.material == NO_MATERIAL);
    if some_name_none && !notes.names.is_empty() {
        materials.push(Material {
            name: DEFAULT_NAME.to_string(),
            albedo: DEFAULT_ALBEDO,
            ..Material::default()
        });
    }
    Ok(materials)
}

/// All albedos of all MTL files; where a name comes twice, the last counts.
fn load_libraries(
    obj: &Path,
    guard: &Guard,
    max_bytes: u64,
    notes: &Notes,
    warnings: &mut Vec<String>,
) -> Result<HashMap<String, Rgb>> {
    let folder = obj.parent().unwrap_or(Path::new(""));
    let mut budget = max_bytes;
    let mut seen: Vec<PathBuf> = Vec::new();
    let mut albedos = HashMap::new();
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
            match guard.open(&path, budget) {
                Ok(file) => {
                    let (defined, bytes) = load_library(file, &path, warnings)
                        .map_err(|fault| fault.into_error(&path))?;
                    albedos.extend(defined);
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
    Ok(albedos)
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

/// The albedos in one MTL file, and the number of bytes read.
fn load_library(
    file: Capped,
    path: &Path,
    warnings: &mut Vec<String>,
) -> std::result::Result<(HashMap<String, Rgb>, u64), Fault> {
    let mut feed = Feed::new(file, Library::default());
    let loaded = tobj::load_mtl_buf(&mut feed);
    let bytes = feed.seen();
    let library = feed.finish(loaded.as_ref().err(), |text, error| {
        format!("{error}: {text}")
    })?;
    let path = path.display();
    if library.outside.count > 0 {
        let told = library.outside.sentence(
            "colour outside 0 to 1 clamped",
            "colours outside 0 to 1 clamped",
        );
        warnings.push(format!("{path}: {told}"));
    }
    if library.unread.count > 0 {
        let told = library.unread.sentence(
            "colour in a form that is not read taken as grey",
            "colours in a form that is not read taken as grey",
        );
        warnings.push(format!("{path}: {told}"));
    }
    let (materials, _) = loaded.unwrap_or_default();
    let albedos = materials.into_iter().map(|material| {
        let albedo = material.diffuse.unwrap_or(DEFAULT_ALBEDO);
        (material.name, albedo.map(|c| c.clamp(0.0, 1.0)))
    });
    Ok((albedos.collect(), bytes))
}

/// Passes on `newmtl` and `Kd`, all that is used of an MTL file. `tobj` panics
/// on a `Kd` of fewer than three numbers.
#[derive(Debug, Default)]
struct Library {
    outside: Tally,
    unread: Tally,
}

impl Translate for Library {
    fn line(
        &mut self,
        line: &str,
        number: usize,
        out: &mut String,
    ) -> std::result::Result<(), Fault> {
        let Some((keyword, rest)) = statement(line) else {
            return Ok(());
        };
        if keyword.eq_ignore_ascii_case("newmtl") {
            let name = name(rest);
            if name.is_empty() {
                return Err(Fault::at(
                    number,
                    "a material without a name: `newmtl NAME`",
                ));
            }
            out.push_str("newmtl ");
            out.push_str(name);
        } else if keyword.eq_ignore_ascii_case("Kd") {
            let data = rest.split('#').next().unwrap_or_default();
            if data.trim_start().starts_with("spectral") || data.trim_start().starts_with("xyz") {
                self.unread.add(number);
                return Ok(());
            }
            let [r, g, b] = colour(data).map_err(|message| Fault::at(number, message))?;
            if [r, g, b].iter().any(|c| !(0.0..=1.0).contains(c)) {
                self.outside.add(number);
            }
            out.push_str(&format!("Kd {r} {g} {b}"));
        }
        Ok(())
    }

    fn end(&mut self) -> std::result::Result<(), Fault> {
        Ok(())
    }
}

/// Three numbers, or one for all three.
fn colour(data: &str) -> std::result::Result<Rgb, String> {
    let parse = |word: &str| match word.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("`{word}` is not a finite number: {COLOUR_FORM}")),
    };
    let values = data.split_whitespace().map(parse);
    match values.collect::<std::result::Result<Vec<_>, _>>()?[..] {
        [grey] => Ok([grey; 3]),
        [r, g, b] => Ok([r, g, b]),
        ref values => Err(format!("{} numbers: {COLOUR_FORM}", values.len())),
    }
}

const COLOUR_FORM: &str = "a diffuse colour is `Kd r g b`, each from 0 to 1";

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

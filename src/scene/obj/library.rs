//! The lines of an MTL file: what they say of each material, as far as it is used.

use std::collections::HashMap;
use std::path::Path;

use super::elements::{name, statement};
use super::feed::{Feed, Translate};
use super::map::{Map, map};
use super::read::Fault;
use super::tally::Tally;
use crate::scene::Rgb;
use crate::scene::guard::Capped;

/// What an MTL file says of a material.
#[derive(Debug, Clone, Default)]
pub(super) struct Described {
    /// `Kd`, if it is given, from 0 to 1.
    pub albedo: Option<Rgb>,
    /// `Ke`, from 0.
    pub emission: Rgb,
    /// `map_Kd`.
    pub texture: Option<Map>,
    /// `map_d`.
    pub holes: Option<Map>,
}

/// The materials of one MTL file, by name; where a name comes twice, the last counts. Also
/// the number of bytes read.
pub(super) fn load_library(
    file: Capped,
    path: &Path,
    warnings: &mut Vec<String>,
) -> Result<(HashMap<String, Described>, u64), Fault> {
    let (library, bytes) = Feed::new(file, Library::default()).run()?;
    let told = [
        library.outside.sentence(
            "colour outside 0 to 1 clamped",
            "colours outside 0 to 1 clamped",
        ),
        library.unread.sentence(
            "colour in a form that is not read taken as grey",
            "colours in a form that is not read taken as grey",
        ),
        library.dark.sentence(
            "emission below 0 or in a form that is not read taken as none",
            "emissions below 0 or in a form that is not read taken as none",
        ),
        library.options.sentence(
            "image with an option that is not applied",
            "images with options that are not applied",
        ),
    ];
    let told = told.into_iter().flatten();
    warnings.extend(told.map(|told| format!("{}: {told}", path.display())));
    Ok((library.materials, bytes))
}

#[derive(Debug, Default)]
struct Library {
    materials: HashMap<String, Described>,
    /// That of the last `newmtl`.
    current: Option<String>,
    outside: Tally,
    unread: Tally,
    dark: Tally,
    options: Tally,
}

impl Library {
    fn albedo(&mut self, rest: &str, number: usize) -> Result<Option<Rgb>, Fault> {
        if is_other_form(rest) {
            self.unread.add(number);
            return Ok(None);
        }
        let albedo = color("Kd", "diffuse", rest).map_err(|message| Fault::at(number, message))?;
        if albedo.iter().any(|c| !(0.0..=1.0).contains(c)) {
            self.outside.add(number);
        }
        Ok(Some(albedo.map(|c| c.clamp(0.0, 1.0))))
    }

    fn emission(&mut self, rest: &str, number: usize) -> Result<Rgb, Fault> {
        if is_other_form(rest) {
            self.dark.add(number);
            return Ok([0.0; 3]);
        }
        let emission =
            color("Ke", "emitted", rest).map_err(|message| Fault::at(number, message))?;
        if emission.iter().any(|&c| c < 0.0) {
            self.dark.add(number);
        }
        Ok(emission.map(|c| c.max(0.0)))
    }

    fn map(&mut self, rest: &str, number: usize) -> Result<Map, Fault> {
        let (map, all_applied) = map(rest, number)?;
        if !all_applied {
            self.options.add(number);
        }
        Ok(map)
    }
}

impl Translate for Library {
    fn line(&mut self, line: &str, number: usize, _: &mut String) -> Result<(), Fault> {
        let Some((keyword, rest)) = statement(line) else {
            return Ok(());
        };
        let mut read = Described::default();
        let is = |other: &str| keyword.eq_ignore_ascii_case(other);
        // Read before it is known whether a material is open: a fault is one anyway.
        let put: fn(&mut Described, Described) = if is("newmtl") {
            let name = name(rest);
            if name.is_empty() {
                let message = "a material without a name: `newmtl NAME`";
                return Err(Fault::at(number, message));
            }
            self.current = Some(name.to_string());
            |material, read| *material = read
        } else if is("Kd") {
            read.albedo = self.albedo(rest, number)?;
            |material, read| material.albedo = read.albedo
        } else if is("Ke") {
            read.emission = self.emission(rest, number)?;
            |material, read| material.emission = read.emission
        } else if is("map_Kd") {
            read.texture = Some(self.map(rest, number)?);
            |material, read| material.texture = read.texture
        } else if is("map_d") {
            read.holes = Some(self.map(rest, number)?);
            |material, read| material.holes = read.holes
        } else {
            return Ok(());
        };
        if let Some(name) = &self.current {
            put(self.materials.entry(name.clone()).or_default(), read);
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), Fault> {
        Ok(())
    }
}

/// Colours may also be given as a file of a spectrum, or in CIE XYZ.
fn is_other_form(rest: &str) -> bool {
    let data = rest.trim_start();
    data.starts_with("spectral") || data.starts_with("xyz")
}

/// Three numbers, or one for all three.
fn color(keyword: &str, what: &str, rest: &str) -> Result<Rgb, String> {
    let data = rest.split('#').next().unwrap_or_default();
    let form = || match keyword {
        "Kd" => format!("a {what} colour is `{keyword} r g b`, each from 0 to 1"),
        _ => format!("an {what} colour is `{keyword} r g b`, each from 0"),
    };
    let parse = |word: &str| match word.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("`{word}` is not a finite number: {}", form())),
    };
    let values = data.split_whitespace().map(parse);
    match values.collect::<Result<Vec<_>, _>>()?[..] {
        [grey] => Ok([grey; 3]),
        [r, g, b] => Ok([r, g, b]),
        ref values => Err(format!("{} numbers: {}", values.len(), form())),
    }
}

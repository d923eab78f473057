//! What in a scene calls for an effect.

use std::fmt::{self, Display};

use crate::scene::{Geometry, Light, Material, Mesh, Origin, Scene, Shape};

/// What in a scene calls for an effect: the first of its kind, and how many more there are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cause {
    /// What it is: a shape, a light, a material, a table of the file.
    pub what: String,
    /// Its line in the file.
    pub line: Option<u32>,
    /// How many more there are.
    pub more: usize,
}

impl Display for Cause {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(&self.what)?;
        if let Some(line) = self.line {
            write!(to, ", line {line}")?;
        }
        match self.more {
            0 => Ok(()),
            more => write!(to, ", and {more} more"),
        }
    }
}

/// The first of some things of a kind, with its number where it has no name.
fn first<T>(
    kind: &str,
    things: &[T],
    origins: &[Origin],
    calls: impl Fn(&T) -> bool,
    name_of: impl Fn(&T) -> Option<String>,
) -> Option<Cause> {
    let mut calling = (0..).zip(things).filter(|(_, thing)| calls(thing));
    let (index, thing) = calling.next()?;
    let more = calling.count();
    let origin = origins.get(index).cloned().unwrap_or_default();
    let what = match origin.name.or_else(|| name_of(thing)) {
        Some(name) => format!("{kind} \"{name}\""),
        None => format!("{kind} {}", index + 1),
    };
    Some(Cause {
        what,
        line: origin.line,
        more,
    })
}

/// A table that there is one of.
fn table(title: &str, origin: &Origin, calls: bool) -> Option<Cause> {
    calls.then(|| Cause {
        what: title.to_owned(),
        line: origin.line,
        more: 0,
    })
}

fn shape(scene: &Scene, kind: &str, calls: impl Fn(&Shape) -> bool) -> Option<Cause> {
    first(kind, &scene.shapes, &scene.origins.shapes, calls, |_| None)
}

fn light(scene: &Scene, kind: &str, calls: impl Fn(&Light) -> bool) -> Option<Cause> {
    first(kind, &scene.lights, &scene.origins.lights, calls, |_| None)
}

fn material(scene: &Scene, calls: impl Fn(&Material) -> bool) -> Option<Cause> {
    let name = |material: &Material| Some(material.name.clone());
    let origins = &scene.origins.materials;
    first("material", &scene.materials, origins, calls, name)
}

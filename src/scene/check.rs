//! Is a scene that was built in code one that can be traced?

mod rule;
mod solid;

use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec3;

use super::{Background, Camera, Geometry, Group, GroupBound, Light, Mesh, Scene, Shape};
use crate::{Error, Result};
pub(super) use rule::*;
pub use rule::{MAX_IMAGE_SIDE, MAX_LIGHTS, MAX_MAGNITUDE, MIN_SIZE};
pub(super) use solid::*;

impl Scene {
    /// Checks what the types cannot: sizes, ranges, directions, indices. A
    /// scene from [`Scene::load`] has passed the same rules.
    ///
    /// Triangles of a mesh may have no area: no ray meets them.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] names the first thing at fault, by its index and value.
    pub fn validate(&self) -> Result<()> {
        image_side("image width", self.image.width.into())
            .and_then(|()| image_side("image height", self.image.height.into()))
            .and_then(|()| camera(&self.camera))
            .and_then(|()| background(&self.background))
            .and_then(|()| color("ambient", self.ambient))
            .and_then(|()| light_count(self.lights.len()))
            .map_err(|flaw| flaw.into_usage("scene"))?;
        for (i, l) in self.lights.iter().enumerate() {
            light(l).map_err(|flaw| flaw.into_usage(&format!("light {i}")))?;
        }
        for (i, m) in self.materials.iter().enumerate() {
            albedo("albedo", m.albedo)
                .map_err(|flaw| flaw.into_usage(&format!("material {i} ({})", m.name)))?;
        }
        let mut extents = Extents::default();
        for (i, s) in self.shapes.iter().enumerate() {
            let name = s.geometry.name();
            shape(s, self.materials.len(), &mut extents)
                .map_err(|flaw| flaw.into_usage(&format!("shape {i} ({name})")))?;
        }
        for (i, g) in self.groups.iter().enumerate() {
            group(g, i, &self.shapes).map_err(|flaw| flaw.into_usage(&format!("group {i}")))?;
        }
        Ok(())
    }
}

impl Geometry {
    /// The kind of shape in a word, as a scene file names it.
    pub fn name(&self) -> &'static str {
        match self {
            Geometry::Sphere { .. } => "sphere",
            Geometry::Plane { .. } => "plane",
            Geometry::Disk { .. } => "disk",
            Geometry::Triangle { .. } => "triangle",
            Geometry::Mesh(_) => "mesh",
        }
    }
}

impl Flaw {
    fn into_usage(self, where_: &str) -> Error {
        Error::Usage(format!("{where_}: {}; {}", self.message, self.help))
    }
}

fn group(group: &Group, index: usize, shapes: &[Shape]) -> Verdict {
    if let Some(parent) = group.parent.filter(|parent| *parent >= index) {
        return Err(Flaw::index("parent", parent, index));
    }
    let Some(own) = shapes.get(group.shapes.clone()) else {
        return Err(Flaw::index("shapes", group.shapes.end, shapes.len()));
    };
    if own
        .iter()
        .any(|shape| matches!(shape.geometry, Geometry::Plane { .. }))
    {
        return Err(Flaw {
            message: "a plane has no bounding volume".into(),
            label: "a plane",
            help: "leave planes out of groups".into(),
        });
    }
    match group.bound {
        GroupBound::Auto => Ok(()),
        GroupBound::Ball { center, radius } => {
            point("center", center)?;
            size("radius", radius)
        }
        GroupBound::Box { low, high } => {
            point("low", low)?;
            point("high", high)?;
            corners(low, high)
        }
    }
}

fn camera(camera: &Camera) -> Verdict {
    point("eye", camera.eye)?;
    point("target", camera.target)?;
    direction("up", camera.up)?;
    field_of_view("fov", camera.fov_degrees)?;
    line_of_sight(camera.eye, camera.target)?;
    upward(camera.up, camera.target - camera.eye)
}

fn background(background: &Background) -> Verdict {
    color("background from", background.from)?;
    color("background to", background.to)?;
    number("background offset", background.offset)?;
    number("background slope", background.slope)
}

fn light(light: &Light) -> Verdict {
    match *light {
        Light::Point {
            position, color: c, ..
        } => point("position", position).and_then(|()| color("color", c)),
        Light::Directional {
            direction: d,
            color: c,
            ..
        } => direction("direction", d).and_then(|()| color("color", c)),
        Light::Area { radiance, .. } => color("radiance", radiance),
    }
}

/// The extent of each distinct mesh, so that a mesh in a thousand places is
/// checked once.
#[derive(Default)]
struct Extents(HashMap<*const Mesh, DVec3>);

fn shape(shape: &Shape, materials: usize, extents: &mut Extents) -> Verdict {
    if shape.material >= materials {
        return Err(Flaw::index("material", shape.material, materials));
    }
    let extent = match &shape.geometry {
        Geometry::Mesh(shared) => match extents.0.get(&Arc::as_ptr(shared)) {
            Some(extent) => *extent,
            None => {
                let extent = mesh(shared, materials)?;
                extents.0.insert(Arc::as_ptr(shared), extent);
                extent
            }
        },
        simple => geometry(simple)?,
    };
    match shape.geometry {
        Geometry::Sphere { .. } | Geometry::Disk { .. } => similarity(shape.transform.linear)?,
        _ => invertible(shape.transform.linear)?,
    }
    point("translate", shape.transform.translate)?;
    within_reach(extent, &shape.transform)
}

#[cfg(test)]
mod tests;

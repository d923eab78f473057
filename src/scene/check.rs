//! Is a scene that was built in code one that can be traced?

mod camera;
mod integrator;
mod light;
mod material;
mod rule;
mod solid;
mod surroundings;

use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec3;

use super::{Geometry, Group, GroupBound, Mesh, Pattern, Scene, Shape, Sky, Texels};
use crate::{Error, Result};
pub(super) use camera::*;
pub use integrator::MAX_SAMPLES;
pub(super) use integrator::*;
pub use light::MAX_LIGHTS;
pub(super) use light::*;
pub(super) use material::*;
pub(super) use rule::*;
pub use rule::{MAX_IMAGE_SIDE, MAX_MAGNITUDE, MIN_SIZE};
pub(super) use solid::*;
pub(super) use surroundings::*;

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
            .and_then(|()| occlusion("occlusion", self.occlusion))
            .and_then(|()| self.fog.as_ref().map_or(Ok(()), fog))
            .and_then(|()| integrator(&self.integrator))
            .and_then(|()| light_count(self.lights.len()))
            .map_err(|flaw| flaw.into_usage("scene"))?;
        let mut images = Images::default();
        if let Some(around) = &self.environment {
            let image = match &around.sky {
                Sky::Image(image) => images.largest(image).map(|_| ()),
                Sky::Gradient(_) => Ok(()),
            };
            image
                .and_then(|()| environment(around))
                .map_err(|flaw| flaw.into_usage("environment"))?;
        }
        for (i, l) in self.lights.iter().enumerate() {
            light(l).map_err(|flaw| flaw.into_usage(&format!("light {i}")))?;
        }
        for (i, m) in self.materials.iter().enumerate() {
            material(m)
                .and_then(
                    |()| match m.texture.as_ref().map(|texture| &texture.pattern) {
                        Some(Pattern::Image(image)) => {
                            images.largest(image).and_then(brightest_texel)
                        }
                        _ => Ok(()),
                    },
                )
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
    point("velocity", shape.velocity)?;
    within_reach(extent, &shape.transform, shape.velocity)
}

/// The largest colour of each distinct image, which is looked through once.
#[derive(Default)]
struct Images(HashMap<*const Texels, f32>);

impl Images {
    fn largest(&mut self, image: &Arc<Texels>) -> std::result::Result<f32, Flaw> {
        if let Some(largest) = self.0.get(&Arc::as_ptr(image)) {
            return Ok(*largest);
        }
        let largest = texels(image).map_err(|flaw| match image.name.as_str() {
            "" => flaw,
            name => flaw.at(name),
        })?;
        self.0.insert(Arc::as_ptr(image), largest);
        Ok(largest)
    }
}

#[cfg(test)]
mod effect_tests;
#[cfg(test)]
mod tests;

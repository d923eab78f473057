//! What in a scene calls for an effect.

use std::fmt::{self, Display};

use glam::DVec3;

use crate::flatten::{camera_power, placed_sphere};
use crate::scene::{AreaForm, Geometry, Light, Material, Origin, Scene, Shape};

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

/// A shape without a name is counted among those of its kind, as in the file.
fn shape(scene: &Scene, calls: impl Fn(&Shape) -> bool) -> Option<Cause> {
    let index = scene.shapes.iter().position(&calls)?;
    let kind = kind_of(&scene.shapes[index]);
    let before = scene.shapes[..index].iter();
    let number = 1 + before.filter(|other| kind_of(other) == kind).count();
    let more = scene.shapes[index + 1..]
        .iter()
        .filter(|shape| calls(shape));
    let origin = scene.origins.shapes.get(index).cloned().unwrap_or_default();
    Some(Cause {
        what: match origin.name {
            Some(name) => format!("{kind} \"{name}\""),
            None => format!("{kind} {number}"),
        },
        line: origin.line,
        more: more.count(),
    })
}

fn kind_of(shape: &Shape) -> &'static str {
    match shape.geometry {
        Geometry::Sphere { .. } => "sphere",
        Geometry::Plane { .. } => "plane",
        Geometry::Disk { .. } => "disk",
        Geometry::Triangle { .. } => "triangle",
        Geometry::Mesh(_) => "mesh",
    }
}

fn light(scene: &Scene, kind: &str, calls: impl Fn(&Light) -> bool) -> Option<Cause> {
    first(kind, &scene.lights, &scene.origins.lights, calls, |_| None)
}

fn material(scene: &Scene, calls: impl Fn(&Material) -> bool) -> Option<Cause> {
    let name = |material: &Material| Some(material.name.clone());
    let origins = &scene.origins.materials;
    first("material", &scene.materials, origins, calls, name)
}

pub(super) fn spheres(scene: &Scene) -> Option<Cause> {
    let is_sphere = |shape: &Shape| matches!(shape.geometry, Geometry::Sphere { .. });
    shape(scene, is_sphere).or_else(|| lamp(scene, |form| matches!(form, AreaForm::Sphere { .. })))
}

pub(super) fn near_spheres(scene: &Scene) -> Option<Cause> {
    let eye = scene.camera.eye;
    let is_near = |shape: &Shape| match shape.geometry {
        // One that moves has another power at each time, and none is noted.
        Geometry::Sphere { center, radius } if shape.velocity == DVec3::ZERO => {
            is_near_sphere(shape, center, radius, eye)
        }
        _ => false,
    };
    let is_near_lamp = |form: &AreaForm| match *form {
        AreaForm::Sphere { center, radius } => {
            camera_power((center - eye).to_array(), radius).is_some()
        }
        _ => false,
    };
    let near = shape(scene, is_near).or_else(|| lamp(scene, is_near_lamp));
    near.map(|cause| Cause {
        what: format!("the camera, near {}", cause.what),
        ..cause
    })
}

pub(super) fn planes(scene: &Scene) -> Option<Cause> {
    let is_plane = |shape: &Shape| matches!(shape.geometry, Geometry::Plane { .. });
    shape(scene, is_plane)
}

pub(super) fn disks(scene: &Scene) -> Option<Cause> {
    let is_disk = |shape: &Shape| matches!(shape.geometry, Geometry::Disk { .. });
    shape(scene, is_disk).or_else(|| lamp(scene, |form| matches!(form, AreaForm::Disk { .. })))
}

pub(super) fn triangles(scene: &Scene) -> Option<Cause> {
    let has_some = |shape: &Shape| match &shape.geometry {
        Geometry::Triangle { .. } => true,
        Geometry::Mesh(mesh) => !mesh.triangles.is_empty(),
        _ => false,
    };
    shape(scene, has_some)
        .or_else(|| lamp(scene, |form| matches!(form, AreaForm::Rectangle { .. })))
}

pub(super) fn smooth_normals(scene: &Scene) -> Option<Cause> {
    let is_smooth = |shape: &Shape| match &shape.geometry {
        Geometry::Mesh(mesh) => !mesh.triangle_normals.is_empty(),
        _ => false,
    };
    shape(scene, is_smooth)
}

pub(super) fn point_lights(scene: &Scene) -> Option<Cause> {
    let is_point = |light: &Light| matches!(light, Light::Point { .. });
    light(scene, "light", is_point)
}

pub(super) fn directional_lights(scene: &Scene) -> Option<Cause> {
    let is_directional = |light: &Light| matches!(light, Light::Directional { .. });
    light(scene, "light", is_directional)
}

pub(super) fn hard_shadows(scene: &Scene) -> Option<Cause> {
    let throws = |light: &Light| {
        matches!(
            light,
            Light::Point { shadow: true, .. } | Light::Directional { shadow: true, .. }
        )
    };
    light(scene, "light", throws)
}

pub(super) fn soft_shadows(scene: &Scene) -> Option<Cause> {
    lamp(scene, |_| true)
}

pub(super) fn mirrors(scene: &Scene) -> Option<Cause> {
    material(scene, |material| material.mirror != [0.0; 3])
}

pub(super) fn glossy_reflection(scene: &Scene) -> Option<Cause> {
    material(scene, |material| {
        material.mirror != [0.0; 3] && material.roughness > 0.0
    })
}

pub(super) fn refraction(scene: &Scene) -> Option<Cause> {
    material(scene, |material| material.ior.is_some())
}

pub(super) fn textures(scene: &Scene) -> Option<Cause> {
    material(scene, |material| material.texture.is_some())
}

pub(super) fn cutouts(scene: &Scene) -> Option<Cause> {
    material(scene, |material| material.cutout)
}

pub(super) fn emission(scene: &Scene) -> Option<Cause> {
    material(scene, |material| material.emission != [0.0; 3]).or_else(|| lamp(scene, |_| true))
}

pub(super) fn environment(scene: &Scene) -> Option<Cause> {
    let is_there = scene.environment.is_some();
    table("[environment]", &scene.origins.environment, is_there)
}

pub(super) fn depth_of_field(scene: &Scene) -> Option<Cause> {
    let has_lens = scene.camera.aperture > 0.0;
    table("the aperture of [camera]", &scene.origins.camera, has_lens)
}

pub(super) fn motion_blur(scene: &Scene) -> Option<Cause> {
    let moves = scene.camera.velocity != DVec3::ZERO;
    shape(scene, |shape| shape.velocity != DVec3::ZERO)
        .or_else(|| table("the velocity of [camera]", &scene.origins.camera, moves))
}

pub(super) fn fog(scene: &Scene) -> Option<Cause> {
    table("[fog]", &scene.origins.fog, scene.fog.is_some())
}

pub(super) fn ambient_occlusion(scene: &Scene) -> Option<Cause> {
    let occludes = scene.occlusion > 0.0;
    table(
        "the occlusion of [ambient]",
        &scene.origins.ambient,
        occludes,
    )
}

pub(super) fn indirect_light(scene: &Scene) -> Option<Cause> {
    let bounces = scene.integrator.bounces > 0;
    table(
        "the bounces of [integrator]",
        &scene.origins.integrator,
        bounces,
    )
}

pub(super) fn anti_aliasing(scene: &Scene) -> Option<Cause> {
    let many = scene.integrator.samples > 1;
    let what = format!("{} samples of [integrator]", scene.integrator.samples);
    table(&what, &scene.origins.integrator, many)
}

/// Whether the camera is near a placed sphere, as [`crate::flatten`] sees it.
fn is_near_sphere(shape: &Shape, center: DVec3, radius: f64, eye: DVec3) -> bool {
    let (center, radius) = placed_sphere(&shape.transform, center, radius, eye);
    camera_power(center.to_array(), radius).is_some()
}

fn lamp(scene: &Scene, is_meant: impl Fn(&AreaForm) -> bool) -> Option<Cause> {
    light(scene, "light", |light| match light {
        Light::Area { form, .. } => is_meant(form),
        _ => false,
    })
}

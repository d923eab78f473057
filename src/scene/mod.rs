//! The scene as the user means it: f64, world coordinates, shapes by name.
//!
//! A scene comes from a TOML file ([`Scene::load`]) or is built in code from
//! the types below, then checked with [`Scene::validate`].

mod camera;
mod check;
mod guard;
mod integrator;
mod light;
mod material;
pub mod mesh;
pub mod obj;
mod origins;
pub mod parse;
pub mod policy;
mod surroundings;
pub mod texels;
mod texture;

use std::ops::Range;
use std::sync::Arc;

use glam::{DMat3, DVec3};

pub use camera::{Camera, Image, PixelSampling, Transfer};
pub use check::{MAX_IMAGE_SIDE, MAX_LIGHTS, MAX_MAGNITUDE, MAX_SAMPLES, MIN_SIZE};
pub use integrator::{Integrator, Strategy};
pub use light::{AreaForm, Falloff, Light};
pub use material::Material;
pub use origins::{Origin, Origins};
pub use surroundings::{Background, Environment, Fog, Sky};
pub use texture::{Pattern, Texels, Texture};

/// A linear RGB colour; 1 is full, values above 1 are allowed.
pub type Rgb = [f64; 3];

/// All that a picture is made of.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Size and tone curve of the picture.
    pub image: Image,
    /// From where and through what lens.
    pub camera: Camera,
    /// What a ray sees that meets nothing.
    pub background: Background,
    /// What shines from all around, in place of the background.
    pub environment: Option<Environment>,
    /// What fills the space between the shapes.
    pub fog: Option<Fog>,
    /// Light from everywhere, multiplied with the albedo.
    pub ambient: Rgb,
    /// How far something has to be not to keep ambient light off; 0 where nothing does.
    pub occlusion: f64,
    /// How the light is added up.
    pub integrator: Integrator,
    /// The lights.
    pub lights: Vec<Light>,
    /// The materials; shapes refer to them by index.
    pub materials: Vec<Material>,
    /// The shapes. Spheres, planes, disks and triangles may be mixed freely.
    pub shapes: Vec<Shape>,
    /// Groups of shapes, each with a bounding volume, see
    /// [`Bounds::Scene`](crate::bounds::Bounds::Scene). A group stands behind the one
    /// that holds it.
    pub groups: Vec<Group>,
    /// Where in a file all this stands, for messages.
    pub origins: Origins,
}

impl Default for Scene {
    /// Nothing, in black, seen from the origin along -z: for scenes that are
    /// built in code.
    fn default() -> Self {
        Self {
            image: Image::default(),
            camera: Camera::default(),
            background: Background::plain([0.0; 3]),
            environment: None,
            fog: None,
            ambient: [0.0; 3],
            occlusion: 0.0,
            integrator: Integrator::default(),
            lights: Vec::new(),
            materials: Vec::new(),
            shapes: Vec::new(),
            groups: Vec::new(),
            origins: Origins::default(),
        }
    }
}

impl Scene {
    /// The same scene as a picture of another size.
    pub fn with_size(mut self, width: u32, height: u32) -> Self {
        self.image.width = width;
        self.image.height = height;
        self
    }
}

/// A shape in the world.
#[derive(Debug, Clone)]
pub struct Shape {
    /// The form, in its own coordinates.
    pub geometry: Geometry,
    /// From its own coordinates to the world's.
    pub transform: Transform,
    /// Index into [`Scene::materials`]. A mesh with materials of its own keeps
    /// those, see [`Mesh::triangle_materials`].
    pub material: usize,
    /// How far it moves while the shutter is open; it stands at its place in the middle of
    /// that time.
    pub velocity: DVec3,
}

/// Shapes, and further groups, in a bounding volume.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// The name by which messages call it.
    pub name: Option<String>,
    /// The volume; what sticks out of one given by hand is cut off.
    pub bound: GroupBound,
    /// The group that holds this one, as an index into [`Scene::groups`].
    pub parent: Option<usize>,
    /// Its own shapes, as indices into [`Scene::shapes`]; no planes.
    pub shapes: Range<usize>,
}

/// The bounding volume of a group, in world coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GroupBound {
    /// The tight sphere around all that the group holds.
    Auto,
    /// A sphere.
    Ball {
        /// The middle.
        center: DVec3,
        /// Greater than 0.
        radius: f64,
    },
    /// An axis-aligned box.
    Box {
        /// The smallest coordinates.
        low: DVec3,
        /// The largest coordinates.
        high: DVec3,
    },
}

/// The form of a shape, in its own coordinates.
#[derive(Debug, Clone)]
pub enum Geometry {
    /// All points at `radius` from `center`.
    Sphere {
        /// The middle.
        center: DVec3,
        /// Greater than 0.
        radius: f64,
    },
    /// An infinite plane.
    Plane {
        /// Any point on it.
        point: DVec3,
        /// Perpendicular to it; any length but zero.
        normal: DVec3,
    },
    /// A flat disk.
    Disk {
        /// The middle.
        center: DVec3,
        /// Perpendicular to it; any length but zero.
        normal: DVec3,
        /// Greater than 0.
        radius: f64,
    },
    /// One triangle.
    Triangle {
        /// The corners; counter-clockwise seen from the front.
        vertices: [DVec3; 3],
    },
    /// Many triangles; shared, so that a mesh can stand in many places.
    Mesh(Arc<Mesh>),
}

/// x -> `linear` * x + `translate`. The two parts stay apart until the scene is
/// flattened, so that a large translation cancels against the camera's
/// position before it meets the small coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transform {
    /// Rotation and scale.
    pub linear: DMat3,
    /// Applied last.
    pub translate: DVec3,
}

impl Default for Transform {
    fn default() -> Self {
        Self {
            linear: DMat3::IDENTITY,
            translate: DVec3::ZERO,
        }
    }
}

/// Triangles with shared vertices.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Vertex positions.
    pub positions: Vec<DVec3>,
    /// Three indices into `positions` a triangle, counter-clockwise seen from
    /// the front.
    pub triangles: Vec<[u32; 3]>,
    /// Vertex normals, unit length; empty where the mesh has none.
    pub normals: Vec<DVec3>,
    /// Three indices into `normals` a triangle; empty where the mesh has none.
    pub triangle_normals: Vec<[u32; 3]>,
    /// Texture coordinates, v upward; empty where the mesh has none.
    pub uvs: Vec<[f64; 2]>,
    /// Three indices into `uvs` a triangle; empty where the mesh has none.
    pub triangle_uvs: Vec<[u32; 3]>,
    /// An index into [`Scene::materials`] a triangle; empty where the whole
    /// mesh takes its shape's material.
    pub triangle_materials: Vec<u32>,
}

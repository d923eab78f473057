//! The scene as the user means it: f64, world coordinates, shapes by name.
//!
//! A scene comes from a TOML file ([`Scene::load`]) or is built in code from
//! the types below, then checked with [`Scene::validate`].

mod check;
pub mod mesh;
pub mod obj;
pub mod parse;
pub mod policy;

use std::ops::Range;
use std::sync::Arc;

use glam::{DMat3, DVec3};

pub use check::{MAX_IMAGE_SIDE, MAX_LIGHTS, MAX_MAGNITUDE, MIN_SIZE};

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
    /// Light from everywhere, multiplied with the albedo.
    pub ambient: Rgb,
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
}

impl Default for Scene {
    /// Nothing, in black, seen from the origin along -z: for scenes that are
    /// built in code.
    fn default() -> Self {
        Self {
            image: Image {
                width: 640,
                height: 480,
                transfer: Transfer::Srgb,
            },
            camera: Camera {
                eye: DVec3::ZERO,
                target: DVec3::NEG_Z,
                up: DVec3::Y,
                fov_degrees: 60.0,
                sampling: PixelSampling::Center,
            },
            background: Background::plain([0.0; 3]),
            ambient: [0.0; 3],
            lights: Vec::new(),
            materials: Vec::new(),
            shapes: Vec::new(),
            groups: Vec::new(),
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

/// Size and tone curve of the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Image {
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
    /// From linear light to the 8 bits of a PNG.
    pub transfer: Transfer,
}

/// From linear light to the 8 bits of a PNG.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Transfer {
    /// The piecewise curve of IEC 61966-2-1.
    Srgb,
    /// Square root, then floor(255.99 c): the curve of the 2017 report.
    Sqrt,
    /// No curve.
    Linear,
}

/// A pinhole camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Position of the pinhole.
    pub eye: DVec3,
    /// The point in the middle of the picture.
    pub target: DVec3,
    /// Which way is up; need not be perpendicular to the line of sight.
    pub up: DVec3,
    /// Full vertical angle of view in degrees, between 0 and 180.
    pub fov_degrees: f64,
    /// Where in a pixel its ray goes through.
    pub sampling: PixelSampling,
}

/// Where in a pixel its ray goes through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PixelSampling {
    /// The middle.
    Center,
    /// The lower left corner, as in the 2017 report.
    Corner,
}

/// What a ray sees that meets nothing: with w = `offset` + `slope` * d.y, where
/// d is the ray's unit direction, the colour is `from` * (1 - w) + `to` * w.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Background {
    /// The colour at w = 0.
    pub from: Rgb,
    /// The colour at w = 1.
    pub to: Rgb,
    /// w at the horizon.
    pub offset: f64,
    /// Change of w from the horizon to the zenith.
    pub slope: f64,
}

impl Background {
    /// The same colour everywhere.
    pub fn plain(color: Rgb) -> Self {
        Self {
            from: color,
            to: color,
            offset: 0.0,
            slope: 0.0,
        }
    }
}

/// A light without size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Light {
    /// Light from one point.
    Point {
        /// Where it is.
        position: DVec3,
        /// Its colour, times its intensity.
        color: Rgb,
        /// How it weakens with distance.
        falloff: Falloff,
    },
    /// Light from infinitely far away.
    Directional {
        /// Towards the light; any length but zero.
        direction: DVec3,
        /// Its colour, times its intensity.
        color: Rgb,
    },
}

/// How a point light weakens with distance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Falloff {
    /// Not at all.
    None,
    /// With the square of the distance.
    InverseSquare,
}

/// How a surface answers light.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// The name by which a scene file refers to it.
    pub name: String,
    /// The fraction of light that a Lambert surface scatters, per channel.
    pub albedo: Rgb,
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
    /// An index into [`Scene::materials`] a triangle; empty where the whole
    /// mesh takes its shape's material.
    pub triangle_materials: Vec<u32>,
}

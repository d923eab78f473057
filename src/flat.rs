//! The scene as plain arrays, which both tracers read.

mod convert;

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use serde::Serialize;

use crate::bounds::screen::tile_masks;
use crate::flatten::camera_power;
use crate::kernel::near_spheres::{FAR, is_near};
use crate::kernel::real::{Real, constant};
use crate::layout::{
    BallRecord, BoxRecord, CameraRecord, Corners, Disk, Environment, FinishRecord, FogRecord,
    LampRecord, LensRecord, LightRecord, MaterialRecord, Pair, Plane, QUAD, SHADOW, SamplingRecord,
    Sphere, Surroundings, TextureRecord, Volume,
};

/// The kinds of primitives that a volume may hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u32)]
pub enum Kind {
    /// Spheres.
    Sphere = 0,
    /// Disks.
    Disk = 1,
    /// Triangles.
    Triangle = 2,
}

/// A scene as the tracers read it.
///
/// Primitive ids count through the spheres, the planes, the disks and the
/// triangles, in the order of the scene. The rows of a table may stand in another
/// order, that of the volumes, so each row tells its id.
#[derive(Debug, Clone)]
pub struct Flat<R> {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The camera; the eye is the origin of everything below.
    pub camera: CameraRecord<R>,
    /// Background and ambient light.
    pub surroundings: Surroundings,
    /// All lights: the point lights, then the directional ones.
    pub lights: Vec<LightRecord>,
    /// All materials.
    pub materials: Vec<MaterialRecord>,
    /// Of each material, how it answers light besides its albedo.
    pub finishes: Vec<FinishRecord>,
    /// How the picture is sampled.
    pub sampling: SamplingRecord,
    /// Samples of a pixel.
    pub samples: u32,
    /// What rough mirrors would throw back that threw back all, by their finishes' rows.
    pub energies: Vec<f32>,
    /// The lamps that have a size.
    pub lamps: Vec<LampRecord>,
    /// What shines from all around.
    pub environment: Environment,
    /// Its tables.
    pub sky: Arc<SkyTables>,
    /// The camera's lens.
    pub lens: LensRecord,
    /// How far the camera goes while the shutter is open.
    pub camera_velocity: [f32; 3],
    /// How far shapes go while the shutter is open.
    pub velocities: Vec<[f32; 3]>,
    /// By the id of a primitive, one more than the row of its velocity, or 0 where it stands
    /// still; empty where all do.
    pub velocity_rows: Vec<u32>,
    /// The fog, with a density of 0 where there is none.
    pub fog: FogRecord,
    /// The textures of the materials.
    pub textures: Vec<TextureRecord>,
    /// The texels of all images, each row by row from the top: red, green, blue and alpha.
    pub texels: Arc<Vec<[f32; 4]>>,
    /// The material of each primitive, by its id.
    pub material_indices: Vec<u32>,
    /// All spheres.
    pub spheres: Vec<Sphere<R>>,
    /// The id of each sphere.
    pub sphere_ids: Vec<u32>,
    /// All planes, in the order of their ids.
    pub planes: Vec<Plane<R>>,
    /// All disks.
    pub disks: Vec<Disk<R>>,
    /// The id of each disk.
    pub disk_ids: Vec<u32>,
    /// All triangles, those of meshes included.
    pub triangles: Vec<Corners>,
    /// The vertices of the triangles, camera-relative.
    pub vertices: Vec<[R; 3]>,
    /// The normal at each vertex, zero where it has none; empty where no vertex has
    /// any.
    pub vertex_normals: Vec<[f32; 3]>,
    /// The texture coordinates at each vertex, v upward, 0, 0 where it has none; empty where
    /// no mesh whose material has a texture has any.
    pub vertex_uvs: Vec<[f32; 2]>,
    /// The groups and meshes of the scene, what volumes may be put around.
    pub parts: Vec<Part<R>>,
    /// A list of volumes and of what they hold; empty where there is none.
    pub volumes: Vec<Volume>,
    /// The volumes that are balls.
    pub balls: Vec<BallRecord<R>>,
    /// The volumes that are boxes.
    pub boxes: Vec<BoxRecord>,
    /// Words of a tile's mask; 0 where the screen is not divided.
    pub tile_words: u32,
    /// See [`Flat::tile_masks`].
    pub tile_masks: OnceLock<Vec<u32>>,
    /// The bounding volume hierarchy, the root first; empty where there is none.
    pub pairs: Vec<Pair>,
}

/// The tables of an environment; without rows where there is none.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SkyTables {
    /// The radiances of an image, row by row from the top; the fourth number is unused.
    pub texels: Vec<[f32; 4]>,
    /// By which directions are drawn, see [`crate::kernel::sky`].
    pub sums: Vec<f32>,
}

/// A group or a mesh of the scene.
#[derive(Debug, Clone)]
pub struct Part<R> {
    /// The group that holds it, an index into [`Flat::parts`].
    pub parent: Option<usize>,
    /// Whether it is a mesh.
    pub is_mesh: bool,
    /// The volume that the scene gives a group by hand, camera-relative.
    pub given: Option<GivenBound<R>>,
    /// Its own primitives, without those of the parts in it.
    pub ids: Vec<Range<u32>>,
}

/// A volume that the scene gives by hand, camera-relative.
#[derive(Debug, Clone, Copy)]
pub enum GivenBound<R> {
    /// A ball.
    Ball(BallRecord<R>),
    /// A box.
    Box(BoxRecord),
}

impl<R> Flat<R> {
    /// The id of the first sphere.
    pub fn first_sphere(&self) -> u32 {
        0
    }

    /// The id of the first plane.
    pub fn first_plane(&self) -> u32 {
        self.spheres.len() as u32
    }

    /// The id of the first disk.
    pub fn first_disk(&self) -> u32 {
        self.first_plane() + self.planes.len() as u32
    }

    /// The id of the first triangle.
    pub fn first_triangle(&self) -> u32 {
        self.first_disk() + self.disks.len() as u32
    }

    /// The masks of the screen's smallest tiles, row by row: in bit e, whether a ray of the
    /// tile may meet volume e. The CPU finds them when it first asks; the shaders find
    /// their own.
    pub fn tile_masks(&self) -> &[u32]
    where
        R: Real,
    {
        self.tile_masks.get_or_init(|| tile_masks(self))
    }

    /// The kind of a primitive that is not a plane, and its number within the kind.
    pub fn kind_of(&self, id: u32) -> (Kind, u32) {
        if id < self.first_plane() {
            (Kind::Sphere, id)
        } else if id < self.first_triangle() {
            (Kind::Disk, id - self.first_disk())
        } else {
            (Kind::Triangle, id - self.first_triangle())
        }
    }

    /// Whether a shape moves while the shutter is open.
    #[inline]
    pub fn has_moving_shapes(&self) -> bool {
        !self.velocities.is_empty()
    }

    /// How far a primitive goes while the shutter is open; none where it stands still.
    #[inline]
    pub fn velocity_of(&self, id: u32) -> Option<[f32; 3]> {
        let row = *self.velocity_rows.get(id as usize)?;
        self.velocities.get(row.checked_sub(1)? as usize).copied()
    }

    /// How many there are of each kind of thing.
    pub fn counts(&self) -> Counts
    where
        R: Real,
    {
        let point_lights = self.surroundings.point_lights as usize;
        Counts {
            spheres: self.spheres.len(),
            near_spheres: self.spheres.iter().filter(|sphere| is_near(sphere)).count(),
            planes: self.planes.len(),
            disks: self.disks.len(),
            triangles: self.triangles.len(),
            vertex_normals: self.vertex_normals.len(),
            pairs: self.pairs.len(),
            volumes: self.volumes.len(),
            balls: self.balls.len(),
            boxes: self.boxes.len(),
            tile_words: self.tile_words,
            point_lights,
            directional_lights: self.lights.len() - point_lights,
            materials: self.materials.len(),
            shadowed_lights: self
                .lights
                .iter()
                .filter(|light| light.flags & SHADOW != 0)
                .count(),
            emissions: self
                .finishes
                .iter()
                .filter(|finish| finish.emission != [0.0; 3])
                .count(),
            occlusion: self.sampling.occlusion > 0.0,
            bounces: self.sampling.bounces,
            samples: self.samples,
            mirrors: self.finishes.iter().filter(|f| f.is_mirror()).count(),
            rough_mirrors: self.finishes.iter().filter(|f| f.is_rough()).count(),
            clear_bodies: self.finishes.iter().filter(|f| f.ior > 0.0).count(),
            lamps: self.lamps.len(),
            environments: self.environment.count,
            lens: self.lens.radius > 0.0,
            moving: self.velocities.len() + usize::from(self.camera_velocity != [0.0; 3]),
            fog: self.fog.density > 0.0,
            textures: self.textures.len(),
            cutouts: self
                .finishes
                .iter()
                .filter(|finish| finish.is_cutout != 0)
                .count(),
        }
    }

    /// Has the camera's powers agree with the spheres' numbers as they are now, rounded.
    pub fn take_powers_anew(&mut self)
    where
        R: Real,
    {
        for (sphere, &id) in self.spheres.iter_mut().zip(&self.sphere_ids) {
            if self.velocity_rows.get(id as usize) > Some(&0) {
                // Its power is another at each time.
                continue;
            }
            let center = sphere.center.map(R::to_f64);
            let power = camera_power(center, sphere.radius.to_f64());
            sphere.power = power.map_or(constant(FAR), R::from_f64);
        }
    }

    /// Bytes of the scene as the shaders read it, in quads, and in this width.
    pub fn bytes(&self) -> u64
    where
        R: Real,
    {
        let quad = QUAD * size_of::<f32>();
        let words = |count: usize| (count * size_of::<u32>()).next_multiple_of(quad);
        let reals = |fours: usize| fours * quad * R::WIDTH.parts();
        let bytes = reals(2 * self.spheres.len())
            + words(self.sphere_ids.len())
            + reals(2 * self.planes.len())
            + reals(2 * self.disks.len())
            + words(self.disk_ids.len())
            + size_of_val(self.triangles.as_slice())
            + reals(self.vertices.len())
            + self.vertex_normals.len() * quad
            + words(2 * self.vertex_uvs.len())
            + size_of_val(self.textures.as_slice())
            + size_of_val(self.texels.as_slice())
            + size_of_val(self.pairs.as_slice())
            + size_of_val(self.volumes.as_slice())
            + reals(self.balls.len())
            + size_of_val(self.boxes.as_slice())
            + size_of_val(self.materials.as_slice())
            + words(self.material_indices.len())
            + size_of_val(self.lights.as_slice())
            + size_of_val(self.lamps.as_slice())
            + size_of_val(self.sky.texels.as_slice())
            + words(self.sky.sums.len());
        bytes as u64
    }

    /// How many primitives there are.
    pub fn primitives(&self) -> u32 {
        self.material_indices.len() as u32
    }
}

/// How many there are of each kind of thing in a scene.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Spheres.
    pub spheres: usize,
    /// Those of them near whose surface the camera is.
    #[serde(skip)]
    pub near_spheres: usize,
    /// Planes.
    pub planes: usize,
    /// Disks.
    pub disks: usize,
    /// Triangles, those of meshes included.
    pub triangles: usize,
    /// Vertices that may have normals: all or none.
    #[serde(skip)]
    pub vertex_normals: usize,
    /// Inner nodes of the tree.
    pub pairs: usize,
    /// Entries of the list of volumes.
    pub volumes: usize,
    /// Those of them that are balls.
    pub balls: usize,
    /// Those of them that are boxes.
    pub boxes: usize,
    /// Words of a tile's mask, where the screen is divided.
    #[serde(skip)]
    pub tile_words: u32,
    /// Point lights.
    pub point_lights: usize,
    /// Directional lights.
    pub directional_lights: usize,
    /// Materials.
    pub materials: usize,
    /// Point lights and directional lights that throw shadows.
    pub shadowed_lights: usize,
    /// Materials that shine by themselves.
    pub emissions: usize,
    /// Whether ambient light may be kept off.
    #[serde(skip)]
    pub occlusion: bool,
    /// How often light may be scattered on its way.
    #[serde(skip)]
    pub bounces: u32,
    /// Samples of a pixel.
    #[serde(skip)]
    pub samples: u32,
    /// Materials that mirror.
    pub mirrors: usize,
    /// Those of them that are rough.
    #[serde(skip)]
    pub rough_mirrors: usize,
    /// Materials of clear bodies.
    pub clear_bodies: usize,
    /// Lamps that have a size.
    pub lamps: usize,
    /// Environments that shine: one or none.
    #[serde(skip)]
    pub environments: u32,
    /// Whether the camera has a lens, not a pinhole.
    #[serde(skip)]
    pub lens: bool,
    /// Shapes, and the camera, that move while the shutter is open.
    #[serde(skip)]
    pub moving: usize,
    /// Whether there is fog.
    #[serde(skip)]
    pub fog: bool,
    /// Textures, one to a material that has one.
    #[serde(skip)]
    pub textures: usize,
    /// Those of them that have holes.
    #[serde(skip)]
    pub cutouts: usize,
}

//! The scene as plain arrays, which both tracers read.

use serde::Serialize;

use crate::layout::{
    CameraRecord, CornerNormals, Disk, LightRecord, MaterialRecord, Pair, Plane, Sphere,
    Surroundings, Triangle,
};

/// A scene as the tracers read it.
///
/// Primitive ids count through the spheres, the planes, the disks and the
/// triangles, in this order.
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
    /// The material of each primitive.
    pub material_indices: Vec<u32>,
    /// All spheres.
    pub spheres: Vec<Sphere<R>>,
    /// All planes.
    pub planes: Vec<Plane<R>>,
    /// All disks.
    pub disks: Vec<Disk<R>>,
    /// All triangles, those of meshes included.
    pub triangles: Vec<Triangle<R>>,
    /// The corner normals of each triangle; empty where no triangle has any.
    pub corner_normals: Vec<CornerNormals>,
    /// The tree's inner nodes, the root first; empty where there is no tree.
    pub pairs: Vec<Pair>,
    /// The primitives of the tree's leaves.
    pub leaf_ids: Vec<u32>,
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

    /// How many there are of each kind of thing.
    pub fn counts(&self) -> Counts {
        let point_lights = self.surroundings.point_lights as usize;
        Counts {
            spheres: self.spheres.len(),
            planes: self.planes.len(),
            disks: self.disks.len(),
            triangles: self.triangles.len(),
            corner_normals: self.corner_normals.len(),
            pairs: self.pairs.len(),
            point_lights,
            directional_lights: self.lights.len() - point_lights,
            materials: self.materials.len(),
        }
    }

    /// Bytes of the largest array of primitives or of tree nodes.
    pub fn largest_array(&self) -> u64 {
        let indices = self.material_indices.len() + self.leaf_ids.len();
        let sizes = [
            indices * size_of::<u32>(),
            size_of_val(self.spheres.as_slice()),
            size_of_val(self.planes.as_slice()),
            size_of_val(self.disks.as_slice()),
            size_of_val(self.triangles.as_slice()),
            size_of_val(self.corner_normals.as_slice()),
            size_of_val(self.pairs.as_slice()),
        ];
        sizes.into_iter().max().unwrap_or(0) as u64
    }

    /// Bytes of all the arrays.
    pub fn bytes(&self) -> u64 {
        let bytes = size_of_val(&self.camera)
            + size_of_val(&self.surroundings)
            + size_of_val(self.lights.as_slice())
            + size_of_val(self.materials.as_slice())
            + size_of_val(self.material_indices.as_slice())
            + size_of_val(self.spheres.as_slice())
            + size_of_val(self.planes.as_slice())
            + size_of_val(self.disks.as_slice())
            + size_of_val(self.triangles.as_slice())
            + size_of_val(self.corner_normals.as_slice())
            + size_of_val(self.pairs.as_slice())
            + size_of_val(self.leaf_ids.as_slice());
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
    /// Planes.
    pub planes: usize,
    /// Disks.
    pub disks: usize,
    /// Triangles, those of meshes included.
    pub triangles: usize,
    /// Triangles that may have smooth normals: all or none.
    #[serde(skip)]
    pub corner_normals: usize,
    /// Inner nodes of the tree.
    pub pairs: usize,
    /// Point lights.
    pub point_lights: usize,
    /// Directional lights.
    pub directional_lights: usize,
    /// Materials.
    pub materials: usize,
}

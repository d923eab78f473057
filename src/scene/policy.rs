//! What a scene may ask of the machine that loads it.

/// Limits on a scene file and on the files that it refers to.
///
/// The default suits scenes from strangers: nothing outside the scene's folder
/// is read, and no file can exhaust the memory.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Policy {
    /// May a mesh or image file lie outside the scene's folder? Default: no.
    pub allow_outside: bool,
    /// Are dropped faces errors in place of warnings? Default: no.
    pub strict: bool,
    /// Bytes of a scene file. Default: 8 MiB, some 120,000 spheres, for which the
    /// worst of files takes about 1 GB to parse; more is for `grid` or a mesh.
    pub max_scene_bytes: u64,
    /// Bytes of one mesh file. Default: 1 GiB; 10 million faces are 359 MB.
    pub max_mesh_bytes: u64,
    /// Triangles of one mesh file. Default: 10 million, for which reading takes
    /// some 1.5 GB, with normals and texture coordinates 2.8 GB.
    pub max_mesh_triangles: u64,
    /// Bytes of one image file. Default: 64 MiB.
    pub max_image_bytes: u64,
    /// Texels of all images of a scene together. Default: 2^23, which are 128 MiB on the
    /// device, as much as every driver gives a buffer.
    pub max_texels: u64,
    /// Shapes after grids are expanded. Default: 2^20, at some 300 bytes each.
    pub max_shapes: u64,
    /// Spheres, planes, disks and triangles after grids are expanded, a mesh
    /// counted as often as it stands. Default: 2^25, some 2 GiB on the device.
    pub max_primitives: u64,
}

impl Default for Policy {
    fn default() -> Self {
        Self {
            allow_outside: false,
            strict: false,
            max_scene_bytes: 8 << 20,
            max_mesh_bytes: 1 << 30,
            max_mesh_triangles: 10_000_000,
            max_image_bytes: 64 << 20,
            max_texels: 1 << 23,
            max_shapes: 1 << 20,
            max_primitives: 1 << 25,
        }
    }
}

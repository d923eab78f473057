//! What the shaders read and write: one record a WGSL struct, field by field.
//!
//! WGSL aligns a `vec3` to four numbers, so every vector here is followed by a
//! scalar or by padding. A test holds offsets, sizes and strides against naga's
//! reflection of the shaders, see [`crate::gpu::program`]. The scene's own records
//! are read as quads, four words at once, so their sizes are multiples of 16 bytes.

mod leaf;
#[macro_use]
mod record;
mod samples;

pub use leaf::{leaf_of, leaf_parts};
pub use record::Record;
pub use samples::{
    DISK_LAMP, Environment, FinishRecord, FogRecord, LampRecord, LampTable, LensRecord,
    MotionRecord, NONE, ONLY_LIGHTS, ONLY_SURFACES, RECTANGLE_LAMP, SPHERE_LAMP, SamplingRecord,
    Tally, TextureRecord,
};

use bytemuck::{Pod, Zeroable};

use crate::kernel::near_spheres::FAR;
use crate::kernel::real::{Real, constant};

/// Stands for "no primitive" in a pixel's `id`.
pub const NO_HIT: u32 = u32::MAX;

/// Words of a quad, the unit in which the shaders read the scene.
pub const QUAD: usize = 4;

/// Set in a [`Volume`]'s bound that is a box, not a ball.
pub const BOX: u32 = 1 << 31;

/// The bound of a [`Volume`] that every ray meets.
pub const EVERYTHING: u32 = u32::MAX;

/// Set in a child of a [`Pair`] that is a leaf: primitives of one kind, a run of
/// rows of its table. The first row is in the lowest bits.
pub const LEAF: u32 = 1 << 31;

/// The kind of a leaf or of a volume's primitives, a [`crate::flat::Kind`], is at this
/// bit.
pub const LEAF_KIND: u32 = 29;

/// A leaf's count less one is at this bit, below the kind.
pub const LEAF_COUNT: u32 = 26;

/// Set in a light's flags: it weakens with the square of the distance.
pub const WEAKENS: u32 = 1;

/// Set in a light's flags: shapes keep it off others.
pub const SHADOW: u32 = 2;

/// A leaf that no tree has: in place of a pair's index or a leaf, nothing.
pub const NOWHERE: u32 = u32::MAX;

real_records! {
    /// The camera, reduced to what a ray needs.
    "Camera" CameraRecord {
        /// From the picture's middle to the middle of its right edge.
        right: [R; 3],
        /// Where in the pixel the ray goes through, from its left edge.
        offset_x: R,
        /// From the picture's middle to the middle of its upper edge.
        up: [R; 3],
        /// Where in the pixel the ray goes through, from its upper edge.
        offset_y: R,
        /// From the eye to the picture's middle; unit length.
        forward: [R; 3],
        /// Unused.
        padding: R,
    }

    /// All points at `radius` from `center`.
    "Sphere" Sphere {
        /// Camera-relative.
        center: [R; 3],
        /// Greater than 0.
        radius: R,
        /// |center|^2 - radius^2, of the numbers before they were rounded, where the
        /// camera is near the surface; else [`FAR`].
        power: R,
        /// Unused.
        padding: [R; 3],
    }

    /// All points within `radius` of `center`: a bounding volume.
    "Ball" BallRecord {
        /// Camera-relative.
        center: [R; 3],
        /// Greater than 0.
        radius: R,
    }

    /// An infinite plane.
    "Plane" Plane {
        /// The plane's point nearest to the camera, camera-relative.
        point: [R; 3],
        /// Unused.
        padding_0: R,
        /// Unit length.
        normal: [R; 3],
        /// Unused.
        padding_1: R,
    }

    /// A flat disk.
    "Disk" Disk {
        /// Camera-relative.
        center: [R; 3],
        /// Greater than 0.
        radius: R,
        /// Unit length.
        normal: [R; 3],
        /// Unused.
        padding: R,
    }

    /// Three corners, camera-relative.
    "Triangle" Triangle {
        /// First corner.
        a: [R; 3],
        /// Unused.
        padding_0: R,
        /// Second corner.
        b: [R; 3],
        /// Unused.
        padding_1: R,
        /// Third corner.
        c: [R; 3],
        /// Unused.
        padding_2: R,
    }
}

impl<R: Real> Sphere<R> {
    /// A sphere that the camera is not near.
    pub fn new(center: [R; 3], radius: R) -> Self {
        Self {
            center,
            radius,
            power: constant(FAR),
            padding: [R::ZERO; 3],
        }
    }
}

records! {
    /// A triangle, by its corners.
    Corners {
        /// Rows of the three vertices.
        vertices: [u32; 3],
        /// The primitive's id.
        id: u32,
    }

    /// An inner node of the tree: the boxes of its two children, quantised, and what
    /// they are.
    ///
    /// A child is a leaf if [`LEAF`] is set, else the index of a pair. On each axis,
    /// the first word holds a step's exponent in its high 8 bits and an origin in
    /// steps in its low 24, signed; the second word holds the left child's low and
    /// high plane and the right child's, from the lowest byte up, in steps from the
    /// origin. Every plane is thus an f32 without rounding.
    Pair {
        /// Along the first axis.
        x: [u32; 2],
        /// Along the second axis.
        y: [u32; 2],
        /// Along the third axis.
        z: [u32; 2],
        /// The left child.
        left: u32,
        /// The right child.
        right: u32,
    }

    /// An entry of the list of volumes, around primitives of its own and the entries
    /// from the next one to before `skip`.
    Volume {
        /// The row of a ball, the row of a box with [`BOX`] set, or [`EVERYTHING`].
        bound: u32,
        /// The first row of its own primitives, with their kind at [`LEAF_KIND`].
        first: u32,
        /// How many primitives of its own it has.
        count: u32,
        /// The entry after all that is in it.
        skip: u32,
    }

    /// An axis-aligned box.
    BoxRecord {
        /// The smallest coordinates.
        low: [f32; 3],
        /// Unused.
        padding_0: f32,
        /// The largest coordinates.
        high: [f32; 3],
        /// Unused.
        padding_1: f32,
    }

    /// How a surface answers light.
    MaterialRecord {
        /// Linear, per channel.
        albedo: [f32; 3],
        /// Unused.
        padding: f32,
    }

    /// A light without size.
    LightRecord {
        /// A point light's position, camera-relative, or a directional light's
        /// unit vector towards it.
        vector: [f32; 3],
        /// [`WEAKENS`], [`SHADOW`], or none of them.
        flags: u32,
        /// Colour times intensity.
        color: [f32; 3],
        /// Unused.
        padding: f32,
    }

    /// Background and ambient light, see [`crate::scene::Background`].
    Surroundings {
        /// The colour at weight 0.
        start: [f32; 3],
        /// The weight at the horizon.
        offset: f32,
        /// The colour at weight 1.
        end: [f32; 3],
        /// Change of the weight from the horizon to the zenith.
        slope: f32,
        /// Light from everywhere.
        ambient: [f32; 3],
        /// So many of the lights, from the first, are point lights; the others
        /// are directional.
        point_lights: u32,
    }

    /// Where each table of the scene begins, in quads, and how they are numbered.
    Tables {
        /// One quad each.
        spheres: u32,
        /// The id of each sphere; four to a quad.
        sphere_ids: u32,
        /// Two quads each.
        planes: u32,
        /// Two quads each.
        disks: u32,
        /// The id of each disk; four to a quad.
        disk_ids: u32,
        /// The rows of three vertices, and the id; one quad each.
        triangles: u32,
        /// One quad each.
        vertices: u32,
        /// One quad each, one to a vertex.
        vertex_normals: u32,
        /// Two quads each, the root first.
        pairs: u32,
        /// One quad each.
        volumes: u32,
        /// How many volumes and runs there are.
        volume_count: u32,
        /// Words of a tile's mask, where the screen is divided.
        tile_words: u32,
        /// One quad each, as spheres.
        balls: u32,
        /// Two quads each.
        boxes: u32,
        /// One quad each.
        materials: u32,
        /// The material of each id; four to a quad.
        material_indices: u32,
        /// Two quads each.
        lights: u32,
        /// How many lights there are.
        light_count: u32,
        /// The first plane's id: so many spheres there are.
        first_plane: u32,
        /// The first disk's id.
        first_disk: u32,
        /// The first triangle's id.
        first_triangle: u32,
    }

    /// A level of the quad-tree over the screen.
    ScreenLevel {
        /// Pixels of a tile's side.
        side: u32,
        /// Tiles side by side.
        across: u32,
        /// Where the level's masks begin.
        first: u32,
        /// 1 for the largest tile, else 0.
        is_root: u32,
        /// Tiles side by side of the level above.
        parent_across: u32,
        /// Where the masks of the level above begin.
        parent_first: u32,
        /// Unused.
        padding: [u32; 2],
    }

    /// A run of primitives of one kind, as rows of its table.
    Run {
        /// The first.
        begin: u32,
        /// One past the last.
        end: u32,
        /// Unused: a struct in a uniform takes whole quads.
        padding: [u32; 2],
    }

    /// What one dispatch is to do.
    Dispatch {
        /// Width and height of the whole picture.
        size: [u32; 2],
        /// The tile's first row.
        first_row: u32,
        /// The tile's number of rows.
        rows: u32,
        /// The spheres to test.
        spheres: Run,
        /// The planes to test.
        planes: Run,
        /// The disks to test.
        disks: Run,
        /// The triangles to test.
        triangles: Run,
        /// 1 in a tile's first dispatch, which starts from "no hit", else 0.
        fresh: u32,
        /// In how many slices the tile's rows of workgroups are dispatched.
        slices: u32,
        /// Entries and primitives of the list of volumes that a ray goes through.
        steps: u32,
        /// 1 in a tile's last dispatch, after which no ray may be on its way, else 0.
        last: u32,
        /// Of a list of rays in doubt, the first that the dispatch is for.
        first_doubtful: u32,
        /// Of paths, how far they are followed: rays one after the other.
        legs: u32,
        /// Of a picture's samples, the one that is taken.
        sample: u32,
        /// Of a picture's samples, the first row that is kept.
        band_row: u32,
    }

    /// A pixel's closest hit so far, carried from one dispatch to the next.
    HitRecord {
        /// The ray's parameter there.
        t: f32,
        /// The primitive, or [`NO_HIT`].
        id: u32,
        /// Its row in its kind's table.
        row: u32,
        /// Shapes tested on the way.
        tests: u32,
    }

    /// What is known of a pixel.
    Pixel {
        /// Linear radiance.
        color: [f32; 3],
        /// Distance from the eye, in world units; zero where nothing is hit.
        depth: f32,
        /// Unit normal of the surface, facing the viewer; zero where nothing is hit.
        normal: [f32; 3],
        /// The primitive, or [`NO_HIT`].
        id: u32,
        /// The point hit, camera-relative; zero where nothing is hit.
        position: [f32; 3],
        /// Shapes tested on the way.
        tests: u32,
    }
}

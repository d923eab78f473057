//! Records of pictures that are made of many samples.

use bytemuck::{Pod, Zeroable};

use super::record::Record;

/// Stands for "no texture", "no lamp" in a [`FinishRecord`].
pub const NONE: u32 = u32::MAX;

/// The number of a [`crate::scene::Strategy`] that searches for lamps alone.
pub const ONLY_LIGHTS: u32 = 1;

/// The number of a [`crate::scene::Strategy`] that lets paths find the lamps.
pub const ONLY_SURFACES: u32 = 2;

/// The form of a [`LampRecord`] that is a sphere.
pub const SPHERE_LAMP: u32 = 0;

/// The form of a [`LampRecord`] that is a disk.
pub const DISK_LAMP: u32 = 1;

/// The form of a [`LampRecord`] that is a parallelogram.
pub const RECTANGLE_LAMP: u32 = 2;

records! {
    /// How a picture is sampled, and where tables begin that only its samples read, in quads.
    SamplingRecord {
        /// What the random numbers are drawn from.
        seed: u32,
        /// How often a path may be scattered.
        bounces: u32,
        /// How often it may be mirrored or refracted.
        reflections: u32,
        /// 0 for both, [`ONLY_LIGHTS`] or [`ONLY_SURFACES`].
        strategy: u32,
        /// How far in a pixel a sample is from its point at most, as a part of its width,
        /// twice: 1 or 0.
        spread: f32,
        /// How far ambient light must be free to come; 0 where it always is.
        occlusion: f32,
        /// Four quads each, one to a material.
        finishes: u32,
        /// Two words to a vertex; [`NONE`] where no vertex has any.
        vertex_uvs: u32,
        /// Three quads each.
        textures: u32,
        /// One quad each.
        texels: u32,
        /// One quad for each four.
        energies: u32,
        /// Unused.
        padding: u32,
    }

    /// How a surface answers light besides its albedo.
    FinishRecord {
        /// The part of light that is mirrored, seen straight on.
        mirror: [f32; 3],
        /// How rough the mirror is: the width of the normals' distribution; 0 for smooth.
        width: f32,
        /// Radiance by itself.
        emission: [f32; 3],
        /// Index of refraction; 0 where the body is not clear.
        ior: f32,
        /// What a clear body takes out of a ray in a unit of length.
        absorption: [f32; 3],
        /// The lamp that it is the surface of, or [`NONE`].
        lamp: u32,
        /// The texture, or [`NONE`].
        texture: u32,
        /// 1 where there is a hole at small alpha, else 0.
        is_cutout: u32,
        /// The row of the table of energies, where the mirror is rough.
        energies: u32,
        /// Unused.
        padding: u32,
    }

    /// A lamp that has a size.
    LampRecord {
        /// The middle, camera-relative.
        center: [f32; 3],
        /// [`SPHERE_LAMP`], [`DISK_LAMP`] or [`RECTANGLE_LAMP`].
        form: u32,
        /// From the middle of a disk or rectangle to its edge.
        right: [f32; 3],
        /// How far it reaches from the camera, by taxicab lengths.
        reach: f32,
        /// The same at a right angle, or to the other edge.
        up: [f32; 3],
        /// Of a sphere.
        radius: f32,
        /// The side of a disk or rectangle that shines; unit length.
        normal: [f32; 3],
        /// Of a disk or rectangle.
        area: f32,
        /// What its front looks like: radiance.
        radiance: [f32; 3],
        /// Unused.
        padding: f32,
    }

    /// Where the lamps that have a size are.
    LampTable {
        /// Where the table begins, five quads a lamp.
        start: u32,
        /// How many there are.
        count: u32,
        /// Unused.
        padding: [u32; 2],
    }

    /// An environment that shines.
    Environment {
        /// Of a ramp, the radiance at weight 0.
        start: [f32; 3],
        /// The weight at the horizon.
        offset: f32,
        /// The radiance at weight 1.
        end: [f32; 3],
        /// Change of the weight from the horizon to the zenith.
        slope: f32,
        /// By how many turns the left edge of an image comes before the direction x, on the
        /// way towards z: from 0 up to but not 1.
        turn: f32,
        /// Texels of an image from left to right; 0 for a ramp.
        width: u32,
        /// Texels from top to bottom.
        height: u32,
        /// Where the table of texels begins, one quad each.
        texels: u32,
        /// Where the sums begin by which directions are drawn, four to a quad.
        sums: u32,
        /// 1 where there is an environment, else 0.
        count: u32,
        /// Unused.
        padding: [u32; 2],
    }

    /// What is kept of a pixel's samples besides their sum.
    Tally {
        /// The sum of the squares of their luminances.
        squares: f32,
        /// Samples that were no numbers, or took more steps than a driver allows: left out.
        faults: u32,
    }

    /// The camera's lens.
    LensRecord {
        /// Rightward, as long as the lens's radius.
        right: [f32; 3],
        /// 0 for a pinhole.
        radius: f32,
        /// Upward, as long as the radius.
        up: [f32; 3],
        /// Unused.
        padding_0: f32,
        /// How far a ray through the end of `right` turns to meet the middle's at the focus, at
        /// distance 1.
        turn_right: [f32; 3],
        /// Unused.
        padding_1: f32,
        /// The same of `up`.
        turn_up: [f32; 3],
        /// Unused.
        padding_2: f32,
    }

    /// How far things go while the shutter is open, and where tables of that begin, in quads.
    MotionRecord {
        /// How far the camera goes.
        camera: [f32; 3],
        /// Shapes that move: where there are none, there are no tables.
        moving: u32,
        /// One quad each.
        velocities: u32,
        /// One word to a primitive, by its id: 0, or one more than a row of `velocities`.
        rows: u32,
        /// Unused.
        padding: [u32; 2],
    }

    /// Fog that is the same everywhere.
    FogRecord {
        /// The part of what it takes out of light that it scatters.
        albedo: [f32; 3],
        /// What it takes out of a ray in a unit of length; 0 where there is none.
        density: f32,
    }

    /// What a texture repeats, and where.
    TextureRecord {
        /// Where the camera is in a repeat of the world.
        offset: [f32; 3],
        /// The length of a repeat of the world.
        size: f32,
        /// A checker's other colour.
        color: [f32; 3],
        /// An image's first texel.
        first: u32,
        /// How often it repeats over a shape's own coordinates, across and upward.
        repeat: [f32; 2],
        /// Texels across; 0 of a checker.
        width: u32,
        /// Texels down.
        height: u32,
    }
}

impl FinishRecord {
    /// Whether it mirrors.
    pub fn is_mirror(&self) -> bool {
        self.mirror != [0.0; 3]
    }

    /// Whether it mirrors, and is rough.
    pub fn is_rough(&self) -> bool {
        self.is_mirror() && self.width > 0.0
    }
}

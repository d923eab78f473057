//! Records of pictures that are made of many samples.

use bytemuck::{Pod, Zeroable};

use super::record::Record;

/// Stands for "no texture", "no lamp" in a [`FinishRecord`].
pub const NONE: u32 = u32::MAX;

/// The number of a [`crate::scene::Strategy`] that searches for lamps alone.
pub const ONLY_LIGHTS: u32 = 1;

/// The number of a [`crate::scene::Strategy`] that lets paths find the lamps.
pub const ONLY_SURFACES: u32 = 2;

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

    /// What is kept of a pixel's samples besides their sum.
    Tally {
        /// The sum of the squares of their luminances.
        squares: f32,
        /// Samples that were no numbers, and left out.
        faults: u32,
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

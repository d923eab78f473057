//! What the shaders read and write: one record a WGSL struct, field by field.
//!
//! WGSL aligns a `vec3` to four numbers, so every vector here is followed by a
//! scalar or by padding. A test holds offsets, sizes and strides against naga's
//! reflection of the shaders, see [`crate::gpu::program`].

use bytemuck::{Pod, Zeroable};

use crate::kernel::real::Real;

/// Stands for "no primitive" in a pixel's `id`.
pub const NO_HIT: u32 = u32::MAX;

/// A record that a WGSL struct mirrors.
pub trait Record {
    /// The WGSL struct's name.
    const NAME: &'static str;
    /// Name and byte offset of each field that is not padding.
    fn fields() -> Vec<(&'static str, usize)>;
    /// Bytes from one element of an array to the next.
    fn stride() -> usize;
}

macro_rules! records {
    ($($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $ty:ty,)* })*) => {$(
        $(#[$doc])*
        #[repr(C)]
        #[derive(Debug, Clone, Copy, Default, PartialEq, Pod, Zeroable)]
        pub struct $name { $($(#[$field_doc])* pub $field: $ty,)* }

        impl Record for $name {
            const NAME: &'static str = stringify!($name);
            fn fields() -> Vec<(&'static str, usize)> {
                vec![$((stringify!($field), std::mem::offset_of!($name, $field)),)*]
                    .into_iter().filter(|(field, _)| !field.starts_with("padding")).collect()
            }
            fn stride() -> usize { size_of::<Self>() }
        }
    )*};
}

macro_rules! real_records {
    ($($(#[$doc:meta])* $wgsl:literal $name:ident { $($(#[$field_doc:meta])* $field:ident: $ty:ty,)* })*) => {$(
        $(#[$doc])*
        #[repr(C)]
        #[derive(Debug, Clone, Copy, Default, PartialEq)]
        pub struct $name<R> { $($(#[$field_doc])* pub $field: $ty,)* }

        #[expect(unsafe_code, reason = "every field is an R or an array of R: no padding")]
        // SAFETY: `Real` is `Pod`, and fields of one type leave no gaps under repr(C).
        unsafe impl<R: Real> Pod for $name<R> {}
        #[expect(unsafe_code, reason = "every field is an R or an array of R")]
        // SAFETY: `Real` is `Zeroable`.
        unsafe impl<R: Real> Zeroable for $name<R> {}

        impl<R: Real> Record for $name<R> {
            const NAME: &'static str = $wgsl;
            fn fields() -> Vec<(&'static str, usize)> {
                vec![$((stringify!($field), std::mem::offset_of!($name<R>, $field)),)*]
                    .into_iter().filter(|(field, _)| !field.starts_with("padding")).collect()
            }
            fn stride() -> usize { size_of::<Self>() }
        }
    )*};
}

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

records! {
    /// The normals at a triangle's corners; zero where it has none.
    CornerNormals {
        /// At the first corner.
        a: [f32; 3],
        /// Unused.
        padding_0: f32,
        /// At the second corner.
        b: [f32; 3],
        /// Unused.
        padding_1: f32,
        /// At the third corner.
        c: [f32; 3],
        /// Unused.
        padding_2: f32,
    }

    /// An inner node of the tree: the boxes of its two children, and what they are.
    Pair {
        /// The left child's box.
        left_low: [f32; 3],
        /// The left child: the index of its pair, or of its first leaf id.
        left: u32,
        /// The left child's box.
        left_high: [f32; 3],
        /// How many leaf ids the left child has; 0 where it is a pair.
        left_count: u32,
        /// The right child's box.
        right_low: [f32; 3],
        /// As `left`.
        right: u32,
        /// The right child's box.
        right_high: [f32; 3],
        /// As `left_count`.
        right_count: u32,
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
        /// 1 where the light weakens with the square of the distance, else 0.
        inverse_square: u32,
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

    /// A run of primitives of one kind.
    Run {
        /// First index into the kind's buffer.
        begin: u32,
        /// One past the last.
        end: u32,
        /// The primitive id of index 0 of the kind's buffer.
        first_id: u32,
        /// Unused.
        padding: u32,
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
        /// The primitive id of index 0 of the material buffer.
        first_id: u32,
        /// How many primitives the bound buffers hold.
        primitives: u32,
        /// 1 in a tile's first dispatch, which starts from "no hit", else 0.
        fresh: u32,
        /// Unused.
        padding: u32,
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

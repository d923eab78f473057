//! The built-in parametric meshes: forms that need no file, as fine as wished.
//!
//! Every mesh is finite, free of degenerate triangles and wound
//! counter-clockwise seen from outside (the terrain: from above). Vertices are
//! shared by index, so neighbours meet without gaps.
//!
//! Only [`Builtin::Knot`] uses `sin` and `cos`; where a platform's differ, its
//! vertices move by an ulp or so. All others have the same bits everywhere.

mod grid;
mod icosphere;
mod knot;
mod solid;
mod subdivide;
mod teapot;
mod teapot_points;
mod terrain;
mod write;

#[cfg(test)]
mod check;
#[cfg(test)]
mod tests;

use super::Mesh;

pub use write::write_obj;

/// The coarsest detail that may be wished for: a tetrahedron's faces.
pub const MIN_DETAIL: u32 = 4;

/// The finest detail that [`build`] gives: at this size the largest mesh takes
/// about two thirds of a gibibyte, and vertex indices are far from the end of `u32`.
pub const MAX_DETAIL: u32 = 10_000_000;

/// A form that is computed from a few numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Builtin {
    /// Newell's teapot: 32 bicubic patches, 64 n^2 - 8 n triangles, n >= 2.
    Teapot,
    /// A unit sphere from an icosahedron: 20 n^2 triangles.
    Icosphere,
    /// A tube along a (2, 3) torus knot: 2 * sides * rings triangles.
    Knot,
    /// A height field of fractal noise over 10 x 10 units: 2 n^2 triangles.
    Terrain,
    /// The unit cube around the origin: 12 n^2 triangles.
    Box,
    /// A regular tetrahedron in the unit sphere: 4 n^2 triangles.
    Tetrahedron,
}

impl Builtin {
    /// Every built-in mesh.
    pub const ALL: [Builtin; 6] = [
        Builtin::Teapot,
        Builtin::Icosphere,
        Builtin::Knot,
        Builtin::Terrain,
        Builtin::Box,
        Builtin::Tetrahedron,
    ];

    /// The mesh of that name, as [`Builtin::name`] gives it.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// The name by which scene files and commands refer to it.
    pub fn name(self) -> &'static str {
        match self {
            Builtin::Teapot => "teapot",
            Builtin::Icosphere => "icosphere",
            Builtin::Knot => "knot",
            Builtin::Terrain => "terrain",
            Builtin::Box => "box",
            Builtin::Tetrahedron => "tetrahedron",
        }
    }

    /// The number of triangles where none is asked for; met exactly.
    pub fn default_detail(self) -> u32 {
        match self {
            Builtin::Teapot => 6_320,
            Builtin::Icosphere => 1_280,
            Builtin::Knot => 12_000,
            Builtin::Terrain => 20_000,
            Builtin::Box => 12,
            Builtin::Tetrahedron => 4,
        }
    }

    /// One line for people: what it is, its size and its triangle counts.
    pub fn describe(self) -> &'static str {
        match self {
            Builtin::Teapot => {
                "Newell's teapot, base on y = 0, 3.15 high, 6.43 wide; 64 n^2 - 8 n triangles"
            }
            Builtin::Icosphere => "sphere of radius 1 from an icosahedron; 20 n^2 triangles",
            Builtin::Knot => {
                "tube along a (2, 3) torus knot, radius 1.5; 2 sides * rings triangles"
            }
            Builtin::Terrain => "fractal hills over 10 x 10 units, y up; 2 n^2 triangles",
            Builtin::Box => "unit cube around the origin; 12 n^2 triangles",
            Builtin::Tetrahedron => "regular tetrahedron of circumradius 1; 4 n^2 triangles",
        }
    }
}

/// Builds `kind` with about `detail` triangles: the count nearest to `detail`
/// that the form allows (the formula stands at each [`Builtin`]), from the
/// form's coarsest to [`MAX_DETAIL`]. A larger wish gives what `MAX_DETAIL`
/// gives. `Box` and `Tetrahedron` are flat and have no normals; all others have
/// one smooth unit normal a vertex. `Icosphere` and `Tetrahedron` have no texture
/// coordinates; on all others a texture is seen upright where the form has an
/// upside, and nowhere in a mirror.
pub fn build(kind: Builtin, detail: u32) -> Mesh {
    let detail = detail.min(MAX_DETAIL);
    match kind {
        Builtin::Teapot => teapot::teapot(detail),
        Builtin::Icosphere => icosphere::icosphere(detail),
        Builtin::Knot => knot::knot(detail),
        Builtin::Terrain => terrain::terrain(detail),
        Builtin::Box => solid::cube(detail),
        Builtin::Tetrahedron => solid::tetrahedron(detail),
    }
}

/// The n >= `least` whose `count(n)` is nearest to `detail`, the smaller on a
/// tie. `count` must grow with n.
fn nearest(detail: u32, least: u32, count: impl Fn(u64) -> u64) -> u32 {
    let detail = u64::from(detail);
    let mut n = u64::from(least);
    while count(n + 1) <= detail {
        n += 1;
    }
    let below = detail.abs_diff(count(n));
    let above = detail.abs_diff(count(n + 1));
    // Every count grows at least as n^2, and `detail` is a u32: n < 2^16 + `least`.
    (if above < below { n + 1 } else { n }) as u32
}

/// A mesh whose normals are one a vertex, under the vertex's own index.
fn smooth(
    positions: Vec<glam::DVec3>,
    normals: Vec<glam::DVec3>,
    triangles: Vec<[u32; 3]>,
) -> Mesh {
    Mesh {
        positions,
        normals,
        triangle_normals: triangles.clone(),
        triangles,
        triangle_materials: Vec::new(),
        ..Mesh::default()
    }
}

//! Stub: parametric meshes.

use glam::DVec3;

use super::Mesh;

/// A built-in mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Builtin {
    /// A teapot.
    Teapot,
    /// A subdivided icosahedron.
    Icosphere,
    /// A torus knot.
    Knot,
    /// Hills.
    Terrain,
    /// A unit cube.
    Box,
    /// A tetrahedron.
    Tetrahedron,
}

impl Builtin {
    /// All of them.
    pub const ALL: [Builtin; 6] = [
        Builtin::Teapot,
        Builtin::Icosphere,
        Builtin::Knot,
        Builtin::Terrain,
        Builtin::Box,
        Builtin::Tetrahedron,
    ];

    /// The one of that name.
    pub fn from_name(name: &str) -> Option<Builtin> {
        Self::ALL.into_iter().find(|b| b.name() == name)
    }

    /// Its name in a scene file.
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

    /// Triangles where the user names no number.
    pub fn default_detail(self) -> u32 {
        4
    }
}

/// A tetrahedron, whatever is asked for.
pub fn build(_kind: Builtin, _detail: u32) -> Mesh {
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    Mesh {
        positions,
        triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
        normals: vec![DVec3::X],
        triangle_normals: vec![[0; 3]; 4],
        triangle_materials: Vec::new(),
    }
}

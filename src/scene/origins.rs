//! Where in a file the parts of a scene stand.

/// Where a part of a scene stands, and what it is called.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Origin {
    /// Its name in the file, where it has one.
    pub name: Option<String>,
    /// Its line in the file, from 1.
    pub line: Option<u32>,
}

/// Where the parts of a scene stand; all empty in a scene that was built in code.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Origins {
    /// `[camera]`.
    pub camera: Origin,
    /// `[ambient]`.
    pub ambient: Origin,
    /// `[environment]`.
    pub environment: Origin,
    /// `[fog]`.
    pub fog: Origin,
    /// `[integrator]`.
    pub integrator: Origin,
    /// Of each light.
    pub lights: Vec<Origin>,
    /// Of each material, its header; of one from a mesh's own file, that of the mesh.
    pub materials: Vec<Origin>,
    /// Of each shape.
    pub shapes: Vec<Origin>,
}

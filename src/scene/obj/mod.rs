//! Stub: Wavefront OBJ files.

use std::path::{Path, PathBuf};

use super::{Material, Mesh};
use crate::{Error, Result};

/// What an OBJ file gave.
#[derive(Debug, Clone, Default)]
pub struct ObjFile {
    /// The triangles.
    pub mesh: Mesh,
    /// The file's materials.
    pub materials: Vec<Material>,
    /// What was passed over.
    pub warnings: Vec<String>,
}

/// How an OBJ file is read.
#[derive(Debug, Clone)]
pub struct ObjOptions {
    /// Cap on the file's bytes.
    pub max_bytes: u64,
    /// Cap on the triangles.
    pub max_triangles: u64,
    /// Dropped faces are errors.
    pub strict: bool,
    /// The folder that files must lie under.
    pub root: Option<PathBuf>,
}

/// Reads `v`, `f` and, as a stand-in for MTL, `usemtl` lines.
pub fn load(path: &Path, _options: &ObjOptions) -> Result<ObjFile> {
    let fail = |line, message: String| Error::Asset {
        path: path.to_owned(),
        line,
        message,
    };
    let text = std::fs::read_to_string(path).map_err(|e| fail(None, e.to_string()))?;
    let mut file = ObjFile::default();
    for (number, line) in text.lines().enumerate() {
        let fail = || fail(Some(number + 1), format!("cannot read `{line}`"));
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let v: Vec<f64> = words.filter_map(|w| w.parse().ok()).collect();
                let v: [f64; 3] = v.try_into().map_err(|_| fail())?;
                file.mesh.positions.push(v.into());
            }
            Some("f") => {
                let f: Vec<u32> = words.filter_map(|w| w.parse().ok()).collect();
                let f: [u32; 3] = f.try_into().map_err(|_| fail())?;
                file.mesh.triangles.push(f.map(|i| i - 1));
                if !file.materials.is_empty() {
                    let last = file.materials.len() as u32 - 1;
                    file.mesh.triangle_materials.push(last);
                }
            }
            Some("usemtl") => file.materials.push(Material {
                name: words.next().unwrap_or_default().to_owned(),
                albedo: [0.5; 3],
            }),
            _ => {}
        }
    }
    Ok(file)
}

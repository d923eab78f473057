//! Wavefront OBJ and MTL files: `tobj` parses the former, this module guards.
//!
//! What `tobj` is given has been read under a cap, cleaned and checked line by
//! line (`elements`), so that every fault has a file, a line and a remedy,
//! and so that nothing is misread in silence. What comes back is triangulated
//! (`polygon`) and checked again (`build`).

mod build;
mod elements;
mod feed;
mod index;
mod library;
mod map;
mod material;
mod polygon;
mod read;
mod tally;

use std::path::{Path, PathBuf};

use super::guard::{Capped, Guard, Refusal};
use super::texels::{ImageOptions, Images};
use super::{Material, Mesh};
use crate::error::Result;
use elements::{Elements, Notes};
use feed::Feed;
use material::Sources;
use read::Fault;

/// What an OBJ file and its MTL files hold.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ObjFile {
    /// The triangles. [`Mesh::triangle_materials`] are indices into
    /// `materials`; empty where no face names a material. Every position is
    /// finite and part of a triangle; every triangle has an area. If some
    /// faces have texture coordinates at each corner, the others take 0, 0.
    pub mesh: Mesh,
    /// The materials that the faces name, in the order of their first use. If
    /// faces without a material come among them, one called `default` is last.
    pub materials: Vec<Material>,
    /// What was left out or guessed, one sentence each, with line numbers;
    /// lines are those of the OBJ file unless a path stands in front.
    pub warnings: Vec<String>,
}

/// What [`load`] may read and how forgiving it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ObjOptions {
    /// The most bytes that the OBJ file may have, and that its MTL files may
    /// have together. Default: 1 GiB, some 20 million triangles.
    pub max_bytes: u64,
    /// The most triangles, degenerate ones included. Default: 10 million,
    /// which takes some 1.5 GB to read, with normals and texture coordinates 2.8 GB.
    pub max_triangles: u64,
    /// Refuse what otherwise is dropped or approximated with a warning:
    /// degenerate, non-finite and too small faces, lines and points,
    /// self-crossing polygons, keywords that are not read. Default: false.
    pub strict: bool,
    /// If given, the OBJ file and its MTL files must lie under this folder,
    /// symbolic links resolved. Default: none.
    pub root: Option<PathBuf>,
}

impl Default for ObjOptions {
    fn default() -> Self {
        Self {
            max_bytes: 1 << 30,
            max_triangles: 10_000_000,
            strict: false,
            root: None,
        }
    }
}

/// Reads an OBJ file and the MTL files that it names.
///
/// Positions are f64 in the file's own units. Polygons are cut into triangles
/// of the same orientation. Vertex colours are checked, not kept.
/// Positions beyond 1e15 in magnitude count as non-finite.
///
/// # Errors
///
/// [`Error::Asset`](crate::Error::Asset), with the line where there is one, if a file is not a
/// regular file, lies outside [`ObjOptions::root`], is over a limit, has a
/// malformed number or an index that refers to nothing; with
/// [`ObjOptions::strict`] also if anything would be dropped. A missing MTL
/// file is a warning. Of the images that the materials in use name, what
/// [`texels::load`](super::texels::load) refuses, with the line that names it; [`ImageOptions`]
/// are the default ones, under the same root.
pub fn load(path: &Path, options: &ObjOptions) -> Result<ObjFile> {
    let images = ImageOptions {
        root: options.root.clone(),
        ..ImageOptions::default()
    };
    load_with(path, options, &mut Images::new(images))
}

/// As [`load`], with images that several files may share.
///
/// # Errors
/// As there.
pub fn load_with(path: &Path, options: &ObjOptions, images: &mut Images) -> Result<ObjFile> {
    let guard = Guard::new(options.root.as_deref())?;
    let file = guard.open(path, options.max_bytes).map_err(|refusal| {
        let message = match refusal {
            Refusal::Missing => "no such file".to_string(),
            Refusal::Refused(message) => message,
        };
        Fault::whole(message).into_error(path)
    })?;
    let (raw, mut notes) = parse(file, options).map_err(|fault| fault.into_error(path))?;
    let mesh = build::build(raw, &mut notes);
    let mut warnings = notes
        .dropped
        .report(options.strict)
        .map_err(|fault| fault.into_error(path))?;
    if mesh.triangles.is_empty() {
        warnings.push("no face in the file: the mesh is empty".to_string());
    }
    let sources = Sources {
        guard: &guard,
        max_bytes: options.max_bytes,
        images,
    };
    let materials = material::resolve(path, sources, &notes, &mut warnings)?;
    Ok(ObjFile {
        mesh,
        materials,
        warnings,
    })
}

/// Streams the file through the checks into `tobj`; all its faces come back as
/// one mesh, in the order of `Notes::faces`.
fn parse(file: Capped, options: &ObjOptions) -> std::result::Result<(tobj::Mesh, Notes), Fault> {
    let mut feed = Feed::new(file, Elements::new(options.max_triangles));
    let loaded = tobj::load_obj_buf(&mut feed, &tobj::LoadOptions::default(), |_| {
        Err(tobj::LoadError::GenericFailure)
    });
    let elements = feed.finish(loaded.as_ref().err(), elements::explain)?;
    // `Elements` passes on no `o`, `g` or `usemtl`, so there is one model.
    let raw = loaded
        .ok()
        .and_then(|(models, _)| models.into_iter().next())
        .map(|model| model.mesh)
        .unwrap_or_default();
    Ok((raw, elements.into_notes()))
}

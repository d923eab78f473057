//! OBJ and MTL files, good, odd and broken: each with its promised outcome.

mod damage;
mod faults;
mod forms;
mod geometry;
mod limits;
mod materials;
mod textures;

use std::fs;
use std::path::Path;

use glam::DVec3;
use rayproof::Error;
use rayproof::scene::obj::{ObjFile, ObjOptions, load};
use tempfile::TempDir;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn folder(files: &[(&str, &[u8])]) -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, bytes) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("in the folder")).expect("a folder");
        fs::write(path, bytes).expect("a file");
    }
    folder
}

fn load_with(bytes: &[u8], options: &ObjOptions) -> Result<ObjFile, Error> {
    let folder = folder(&[("a.obj", bytes)]);
    load(&folder.path().join("a.obj"), options)
}

fn read(text: impl AsRef<[u8]>) -> ObjFile {
    load_with(text.as_ref(), &ObjOptions::default()).expect("a readable file")
}

/// Line and message of the fault.
fn fault(text: impl AsRef<[u8]>) -> (Option<usize>, String) {
    fault_with(text.as_ref(), &ObjOptions::default())
}

fn fault_with(text: &[u8], options: &ObjOptions) -> (Option<usize>, String) {
    split(load_with(text, options).expect_err("a fault"), "a.obj")
}

fn split(error: Error, file: &str) -> (Option<usize>, String) {
    assert_eq!(error.exit_code(), 3);
    match error {
        Error::Asset {
            path,
            line,
            message,
        } => {
            assert!(path.ends_with(file), "{}", path.display());
            (line, message)
        }
        other => panic!("another kind of error: {other}"),
    }
}

#[track_caller]
fn assert_fault(text: impl AsRef<[u8]>, line: impl Into<Option<usize>>, words: &[&str]) {
    let (found, message) = fault(text);
    assert_eq!(found, line.into(), "{message}");
    for word in words {
        assert!(message.contains(word), "`{word}` is not in: {message}");
    }
}

fn strict() -> ObjOptions {
    ObjOptions {
        strict: true,
        ..ObjOptions::default()
    }
}

/// Whatever was read: what the type promises.
fn assert_sound(file: &ObjFile) {
    let mesh = &file.mesh;
    let usable = |v: &DVec3| v.is_finite() && v.abs().max_element() <= 1e15;
    assert!(mesh.positions.iter().all(usable));
    assert!(
        mesh.normals
            .iter()
            .all(|n| (n.length() - 1.0).abs() < 1e-15)
    );
    let within = |indices: &[[u32; 3]], count: usize| {
        indices.as_flattened().iter().all(|&i| (i as usize) < count)
    };
    assert!(within(&mesh.triangles, mesh.positions.len()));
    assert!(within(&mesh.triangle_normals, mesh.normals.len()));
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| mesh.positions[i as usize]);
        assert_ne!((b - a).cross(c - a), DVec3::ZERO);
    }
    let of_each = [mesh.triangle_normals.len(), mesh.triangle_materials.len()];
    for count in of_each {
        assert!(count == 0 || count == mesh.triangles.len());
    }
    let materials = file.materials.len() as u32;
    assert!(mesh.triangle_materials.iter().all(|&m| m < materials));
}

#[test]
#[should_panic]
fn the_soundness_check_can_fail() {
    let mut file = read(format!("{TRIANGLE}f 1 2 3\n"));
    file.mesh.positions[2].y = 0.0;
    assert_sound(&file);
}

//! Which files are read, and how much of them.

use super::*;

#[test]
fn an_empty_file_is_an_empty_mesh_and_a_warning() {
    for text in ["", "# nothing\n", "\u{feff}", TRIANGLE] {
        let file = read(text);
        assert_eq!(file.mesh, Default::default());
        assert_eq!(file.warnings, ["no face in the file: the mesh is empty"]);
    }
}

#[test]
fn limits_are_exact_and_told_with_both_numbers() {
    let text = format!("{TRIANGLE}f 1 2 3\nf 1 2 3\nf 1 2 3\n");
    let triangles = |max_triangles| ObjOptions {
        max_triangles,
        ..ObjOptions::default()
    };
    let bytes = |max_bytes| ObjOptions {
        max_bytes,
        ..ObjOptions::default()
    };
    assert!(load_with(text.as_bytes(), &triangles(3)).is_ok());
    let (_, message) = fault_with(text.as_bytes(), &triangles(2));
    assert_eq!(message, "3 triangles, more than the 2 allowed");
    let size = text.len() as u64;
    assert!(load_with(text.as_bytes(), &bytes(size)).is_ok());
    let (_, message) = fault_with(text.as_bytes(), &bytes(size - 1));
    let expected = format!("has {size} bytes, more than the {} allowed", size - 1);
    assert!(message.ends_with(&expected), "{message}");
}

#[test]
fn only_files_are_opened() {
    let folder = folder(&[]);
    let refused = |path: &Path| match load(path, &ObjOptions::default()) {
        Err(Error::Asset { message, .. }) => message,
        other => panic!("{other:?}"),
    };
    assert_eq!(refused(&folder.path().join("none.obj")), "no such file");
    assert!(refused(folder.path()).contains("a folder"));
}

#[cfg(unix)]
#[test]
fn devices_pipes_and_links_to_them_are_refused() {
    use std::os::unix::fs::symlink;
    let folder = folder(&[("real.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")]);
    let pipe = folder.path().join("pipe.obj");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("mkfifo").success());
    let link = folder.path().join("link.obj");
    symlink("/dev/zero", &link).expect("a link");
    for path in [Path::new("/dev/zero"), &pipe, &link] {
        let error = load(path, &ObjOptions::default()).expect_err("refused");
        assert!(error.to_string().contains("not a regular file"), "{error}");
        let text = format!("mtllib {}\n", path.display());
        let (line, message) = fault(text);
        assert_eq!(line, Some(1));
        assert!(message.contains("not a regular file"), "{message}");
    }
    let good = folder.path().join("good.obj");
    symlink(folder.path().join("real.obj"), &good).expect("a link");
    assert!(load(&good, &ObjOptions::default()).is_ok());
}

#[test]
fn nothing_outside_the_root_is_read() {
    let folder = folder(&[
        ("outside.mtl", b"newmtl m\nKd 1 0 0\n"),
        ("outside.obj", b"f"),
        ("in/inside.mtl", b"newmtl m\nKd 0 1 0\n"),
        ("in/good.obj", b"mtllib ../in/inside.mtl\n"),
        ("in/bad.obj", b"\n\nmtllib ../outside.mtl\n"),
    ]);
    let root = folder.path().join("in");
    let options = ObjOptions {
        root: Some(root.clone()),
        ..ObjOptions::default()
    };
    assert!(load(&root.join("good.obj"), &options).is_ok());
    let root_name = root.canonicalize().expect("a folder").display().to_string();
    for (file, line, refused) in [
        ("in/bad.obj", Some(3), "outside.mtl"),
        ("in/../outside.obj", None, "outside.obj"),
    ] {
        let error = load(&folder.path().join(file), &options).expect_err("refused");
        let (found, message) = split(error, file);
        assert_eq!(found, line);
        assert!(
            message.contains(refused) && message.contains(&root_name),
            "{message}"
        );
        // The control: without the root they are read.
        assert!(load(&folder.path().join(file), &ObjOptions::default()).is_ok());
    }
}

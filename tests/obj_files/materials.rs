//! MTL files.

use super::*;

#[test]
fn materials_by_name() {
    let obj = format!(
        "mtllib a.mtl my colours.mtl\n{TRIANGLE}usemtl unused\nusemtl Material #25\nf 1 2 3\n\
         usemtl red # bright\nf 3 2 1\nf 1 2 2\nusemtl Material #25\nf 2 3 1\n"
    );
    let folder = folder(&[
        ("a.obj", obj.as_bytes()),
        (
            "a.mtl",
            b"\xef\xbb\xbfnewmtl red\r\nNs oops\r\nKd 1 0.25 0\r\nillum x\r\n",
        ),
        (
            "my colours.mtl",
            b"NEWMTL Material #25\nKD 0.5 # grey\n\nnewmtl unused\n",
        ),
    ]);
    let file = load(&folder.path().join("a.obj"), &ObjOptions::default()).expect("readable");
    assert_sound(&file);
    let found: Vec<_> = file
        .materials
        .iter()
        .map(|m| (&m.name[..], m.albedo))
        .collect();
    assert_eq!(
        found,
        [("Material #25", [0.5; 3]), ("red", [1.0, 0.25, 0.0])]
    );
    assert_eq!(file.mesh.triangle_materials, [0, 1, 0]);
    assert_eq!(file.warnings, ["1 degenerate face dropped (line 10)"]);
}

#[test]
fn faces_without_a_material_take_the_default() {
    let file = read(format!(
        "{TRIANGLE}f 1 2 3\nusemtl a\nf 1 2 3\nusemtl\nf 1 2 3\n"
    ));
    assert_sound(&file);
    assert_eq!(file.mesh.triangle_materials, [1, 0, 1]);
    assert_eq!(file.materials[1].name, "default");
    assert_eq!(file.materials[1].albedo, [0.8; 3]);
    assert_eq!(
        file.warnings,
        ["material `a` is defined nowhere: taken as grey"]
    );
}

#[test]
fn a_missing_mtl_file_is_a_warning_that_names_it() {
    let file = read(format!(
        "{TRIANGLE}mtllib gone.mtl\nmtllib gone.mtl\nusemtl a\nf 1 2 3\n"
    ));
    assert_eq!(file.materials.len(), 1);
    assert_eq!(file.materials[0].name, "a");
    assert_eq!(file.materials[0].albedo, [0.8; 3]);
    assert_eq!(file.warnings.len(), 2);
    assert!(file.warnings[0].contains("gone.mtl"), "{:?}", file.warnings);
}

#[test]
fn mtl_files_may_not_be_without_number() {
    let many: String = (0..65).map(|i| format!("mtllib {i}.mtl\n")).collect();
    assert_fault(many, 65, &["64 MTL files"]);
}

fn load_mtl(mtl: &str, options: &ObjOptions) -> Result<ObjFile, Error> {
    let obj = format!("mtllib a.mtl\n{TRIANGLE}usemtl m\nf 1 2 3\n");
    let folder = folder(&[("a.obj", obj.as_bytes()), ("a.mtl", mtl.as_bytes())]);
    load(&folder.path().join("a.obj"), options)
}

#[test]
fn odd_mtl_files() {
    for (mtl, albedo, warning) in [
        (
            "newmtl m\nKd 1.5 0.5 -1\n",
            [1.0, 0.5, 0.0],
            "outside 0 to 1 clamped (line 2)",
        ),
        (
            "newmtl m\nKd spectral a.rfl\n",
            [0.8; 3],
            "not read taken as grey (line 2)",
        ),
        (
            "Kd 1 0 0\nnewmtl other\n",
            [0.8; 3],
            "`m` is defined nowhere",
        ),
    ] {
        let file = load_mtl(mtl, &ObjOptions::default()).expect("readable");
        assert_eq!(file.materials[0].albedo, albedo);
        assert_eq!(file.warnings.len(), 1, "{:?}", file.warnings);
        assert!(file.warnings[0].contains(warning), "{:?}", file.warnings);
    }
    let file = load_mtl(
        "newmtl m\nKd 1 0 0\nnewmtl m\nKd 0 1 0",
        &ObjOptions::default(),
    );
    assert_eq!(file.expect("readable").materials[0].albedo, [0.0, 1.0, 0.0]);
}

#[test]
fn broken_mtl_files_have_a_line() {
    for (text, word) in [
        ("Kd 1 0", "2 numbers"),
        ("Kd", "0 numbers"),
        ("Kd 1 0 0 0", "4 numbers"),
        ("Kd 1 x 0", "`x` is not a finite number"),
        ("Kd 1 nan 0", "`nan` is not a finite number"),
        ("Ke 1 0", "an emitted colour is `Ke r g b`"),
        ("map_Kd -clamp on", "without a name"),
        ("map_Kd -s 0 a.png", "`-s u v`"),
        ("newmtl", "without a name"),
        ("newmtl # red", "without a name"),
    ] {
        let error = load_mtl(&format!("newmtl m\n\n{text}\n"), &ObjOptions::default());
        let (line, message) = split(error.expect_err(text), "a.mtl");
        assert_eq!(line, Some(3));
        assert!(message.contains(word), "{message}");
    }
}

#[test]
fn mtl_files_share_the_limit_on_bytes() {
    let options = ObjOptions {
        max_bytes: 100,
        ..ObjOptions::default()
    };
    let mtl = |length: usize| format!("newmtl m\n#{}", "-".repeat(length - 10));
    assert!(load_mtl(&mtl(100), &options).is_ok());
    let (line, message) = split(load_mtl(&mtl(101), &options).expect_err("large"), "a.obj");
    assert_eq!(line, Some(1));
    assert!(message.contains("101 bytes"), "{message}");
}

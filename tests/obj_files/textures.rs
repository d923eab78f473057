//! Texture coordinates, and the images of materials.

use std::sync::Arc;

use rayproof::frame::write_rgb8;
use rayproof::scene::{Material, Pattern, Texture};

use super::*;

/// The texture coordinates at the corners of each triangle.
fn uvs(file: &ObjFile) -> Vec<[[f64; 2]; 3]> {
    let mesh = &file.mesh;
    mesh.triangle_uvs
        .iter()
        .map(|corners| corners.map(|uv| mesh.uvs[uv as usize]))
        .collect()
}

const FOUR: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1 7\nvt 0 1\n";

#[test]
fn every_form_of_a_corner_keeps_its_coordinates() {
    let expected = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
    for face in [
        "f 1/1 2/2 3/3",
        "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1",
        "f -4/-4 -3/-3 -2/-2",
    ] {
        let file = read(format!("{FOUR}{face}\n"));
        assert_eq!(uvs(&file), [expected], "{face}");
        assert!(file.warnings.is_empty());
        // The fourth is used by no one.
        assert_eq!(file.mesh.uvs.len(), 3);
    }
    for face in ["f 1 2 3", "vn 0 0 1\nf 1//1 2//1 3//1"] {
        let file = read(format!("{FOUR}{face}\n"));
        assert!(file.mesh.uvs.is_empty() && file.mesh.triangle_uvs.is_empty());
    }
}

#[test]
fn one_number_is_a_u() {
    let file = read(format!("{TRIANGLE}vt 0.25\nf 1/1 2/1 3/1\n"));
    assert_eq!(uvs(&file), [[[0.25, 0.0]; 3]]);
}

#[test]
fn coordinates_may_come_after_the_face() {
    let file = read(format!("{TRIANGLE}f 1/2 2/1 3/1\nvt 3 4\nvt 5 6\n"));
    assert_eq!(uvs(&file), [[[5.0, 6.0], [3.0, 4.0], [3.0, 4.0]]]);
}

#[test]
fn polygons_are_cut_with_their_coordinates() {
    // Concave, so that no fan from the first corner will do; u and v are twice x and y.
    let outline = [[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]];
    let mut text = String::new();
    for [x, y] in outline {
        text += &format!("v {x} {y} 0\nvt {} {}\n", 2 * x, 2 * y);
    }
    let file = read(format!("{text}f 1/1 2/2 3/3 4/4 4/4 5/5\n"));
    assert_eq!(file.mesh.triangles.len(), 3);
    for (triangle, uvs) in file.mesh.triangles.iter().zip(uvs(&file)) {
        for (&place, [u, v]) in triangle.iter().zip(uvs) {
            let place = file.mesh.positions[place as usize];
            assert_eq!([2.0 * place.x, 2.0 * place.y], [u, v]);
        }
    }
}

#[test]
fn a_face_that_lacks_some_takes_the_origin() {
    let file = read(format!("{FOUR}f 1/3 2/3 3/3\nf 1 3 4\nf 1/2 3 4/2\n"));
    let ones = [[1.0, 1.0]; 3];
    assert_eq!(uvs(&file), [ones, [[0.0; 2]; 3], [[0.0; 2]; 3]]);
    assert!(file.warnings.is_empty());
}

#[test]
fn wild_coordinates_are_told_and_not_taken() {
    for wild in ["nan 0", "0 inf", "-inf", "0 1e16"] {
        let text = format!("{FOUR}vt {wild}\nf 1/2 2/2 3/5\nf 1/2 3/2 4/2\n");
        let file = read(&text);
        assert_eq!(uvs(&file), [[[0.0; 2]; 3], [[1.0, 0.0]; 3]], "{wild}");
        assert_eq!(file.warnings.len(), 1);
        assert!(
            file.warnings[0].contains("texture coordinates"),
            "{:?}",
            file.warnings
        );
        let strict = ObjOptions {
            strict: true,
            ..ObjOptions::default()
        };
        assert_eq!(fault_with(text.as_bytes(), &strict).0, Some(10));
    }
}

/// What two materials become, `m` and `n`, in a folder with the images `a b.png` and
/// `in/a.png`.
fn materials(mtl: &str) -> Result<ObjFile, Error> {
    let obj = format!("mtllib a.mtl\n{TRIANGLE}usemtl m\nf 1 2 3\nusemtl n\nf 1 2 3\n");
    let files = [("a.obj", obj.as_bytes()), ("a.mtl", mtl.as_bytes())];
    let folder = folder(&files);
    fs::create_dir(folder.path().join("in")).expect("a folder");
    for name in ["a b.png", "in/a.png"] {
        write_rgb8(&folder.path().join(name), 1, 1, &[255, 0, 0]).expect("an image");
    }
    let options = ObjOptions {
        root: Some(folder.path().to_owned()),
        ..ObjOptions::default()
    };
    load(&folder.path().join("a.obj"), &options)
}

fn image(material: &Material) -> (Arc<rayproof::scene::Texels>, [f64; 2]) {
    match material.texture.as_ref().expect("a texture") {
        Texture {
            pattern: Pattern::Image(image),
            repeat,
            ..
        } => (Arc::clone(image), *repeat),
        other => panic!("{other:?}"),
    }
}

#[test]
fn materials_take_their_images() {
    let mtl = "newmtl m\nmap_Kd -s 2 3 a b.png\n\
               newmtl n\nKd 0.5 0.5 1\nKe 2 0 0\nmap_Kd a b.png\nmap_d a b.png\n";
    let file = materials(mtl).expect("readable");
    assert!(file.warnings.is_empty(), "{:?}", file.warnings);
    let [m, n] = &file.materials[..] else {
        panic!("two materials")
    };
    let ((first, repeat), (second, once)) = (image(m), image(n));
    assert_eq!((first.width, first.texels[0]), (1, [1.0, 0.0, 0.0, 1.0]));
    assert!(Arc::ptr_eq(&first, &second), "the file is loaded once");
    assert_eq!((repeat, once), ([2.0, 3.0], [1.0, 1.0]));
    // The image is multiplied by Kd, by 1 where there is none.
    assert_eq!((m.albedo, n.albedo), ([1.0; 3], [0.5, 0.5, 1.0]));
    assert_eq!((m.emission, n.emission), ([0.0; 3], [2.0, 0.0, 0.0]));
    assert_eq!((m.cutout, n.cutout), (false, true));
}

#[test]
fn what_is_not_applied_is_told() {
    for (mtl, warning) in [
        (
            "map_Kd -o 0.5 0 0 in\\a.png",
            "1 image with an option that is not applied (line 2)",
        ),
        (
            "map_Kd in/a.png\nmap_d a b.png",
            "map_d (line 3) not applied",
        ),
        ("map_d a b.png", "map_d (line 2) not applied"),
        ("Ke -1 0 0", "emission below 0"),
        ("Ke xyz 1 1 1", "emission below 0 or in a form"),
    ] {
        let file = materials(&format!("newmtl m\n{mtl}\nnewmtl n\n")).expect("readable");
        assert_eq!(file.warnings.len(), 1, "{:?}", file.warnings);
        assert!(file.warnings[0].contains(warning), "{:?}", file.warnings);
        assert_eq!(file.materials[0].emission, [0.0; 3]);
        assert!(!file.materials[0].cutout);
    }
}

#[test]
fn an_image_that_cannot_be_had_is_a_fault_of_its_line() {
    for (name, words) in [
        ("gone.png", ["map_Kd", "gone.png", "no such file"]),
        ("../a.png", ["map_Kd", "../a.png", ""]),
        ("a.mtl", ["map_Kd", "a.mtl", "no PNG"]),
        ("in", ["map_Kd", "in", "a folder"]),
        ("/dev/null", ["map_Kd", "/dev/null", "outside"]),
    ] {
        let mtl = format!("newmtl n\nnewmtl m\n\nmap_Kd {name}\n");
        let (line, message) = split(materials(&mtl).expect_err(name), "a.mtl");
        assert_eq!(line, Some(4));
        assert!(words.iter().all(|word| message.contains(word)), "{message}");
    }
    // What no face uses is not looked for.
    assert!(materials("newmtl other\nmap_Kd gone.png\nnewmtl m\nnewmtl n\n").is_ok());
}

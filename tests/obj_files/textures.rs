//! Texture coordinates.

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

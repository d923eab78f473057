//! Legal forms, ordinary and odd.

use super::*;

#[test]
fn a_triangle() {
    let file = read(format!("{TRIANGLE}f 1 2 3\n"));
    assert_eq!(file.mesh.positions, [DVec3::ZERO, DVec3::X, DVec3::Y]);
    assert_eq!(file.mesh.triangles, [[0, 1, 2]]);
    assert!(file.mesh.normals.is_empty() && file.mesh.triangle_normals.is_empty());
    assert!(file.mesh.triangle_materials.is_empty() && file.materials.is_empty());
    assert_eq!(file.warnings, [""; 0]);
}

#[test]
fn positions_are_f64() {
    let file = read("v 0.1 0 0\nv 148376.00000001 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_eq!(file.mesh.positions[0].x, 0.1);
    assert_eq!(file.mesh.positions[1].x, 148376.00000001);
}

/// Legal forms that `tobj` alone refuses or misreads; all are one triangle.
#[test]
fn forms_of_one_triangle() {
    let expected = read(format!("{TRIANGLE}f 1 2 3\n")).mesh;
    let forms: &[&[u8]] = &[
        b"\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
        b"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
        b"v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
        b"v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 \\\r\n 2\\\n 3\n",
        b"# caf\xe9\nv 0 0 0\nv 1 0 0 # caf\xe9\nv 0 1 0\nf 1 2 3 # first\n",
        b"# C:\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        b"g caf\xe9\nV 0 0 0\nV 1 0 0\nV 0 1 0\nF 1 2 3\n",
        b"\tv\t0\t0\t0\nv  1 0 0 \n  v 0 1 0\nf\t1 2\t3\n",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n",
        b"f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n",
        b"v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 0.5 0.5\nf 1 2 3\n",
        b"v 0 0 0 2\nv 4 0 0 4\nv 0 1 0 1\nf 1 2 3\n",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\nvt 1\nf 1 2 2 3\n",
        b"v nan inf 1e400\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n",
        b"o a\ng b c\ns off\nv 0 0 0\nv 1 0 0\no d\nv 0 1 0\nf 1 2 3\n",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf +1 2 3 3\n",
    ];
    for form in forms {
        let text = String::from_utf8_lossy(form);
        let file = load_with(form, &strict()).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_sound(&file);
        let triangles = &file.mesh.triangles;
        assert!(triangles.iter().all(|t| *t == [0, 1, 2]), "{text}");
        assert_eq!(file.mesh.positions, expected.positions, "{text}");
        assert_eq!(file.warnings, [""; 0], "{text}");
    }
}

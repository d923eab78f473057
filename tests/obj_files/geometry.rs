//! Polygons and normals.

use super::*;

#[test]
fn polygons_keep_their_area_and_orientation() {
    let dart = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\n";
    for (face, sign) in [("2 3 4 1", 1.0), ("1 4 3 2", -1.0), ("3 2 1 4", -1.0)] {
        let mesh = read(format!("{dart}f {face}\n")).mesh;
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
            (b - a).cross(c - a).z / 2.0
        };
        let areas: Vec<_> = mesh.triangles.iter().map(area).collect();
        assert_eq!(areas.len(), 2);
        assert!(areas.iter().all(|a| a * sign > 0.0), "{areas:?}");
        assert_eq!(areas.iter().sum::<f64>(), 4.0 * sign);
    }
    let quad = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").mesh;
    assert_eq!(quad.triangles, [[0, 1, 2], [0, 2, 3]]);
}

#[test]
fn normals_follow_the_corners() {
    let text = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\n\
        vn 0 0 2\nvn 0 3 4\nvn 5 0 0\nvn 1e-200 0 1e-200\nf 2//1 3//2 4//3 1//4\n";
    let mesh = read(text).mesh;
    let half = 0.5f64.sqrt();
    let normals = [
        (DVec3::new(4.0, 0.0, 0.0), DVec3::Z),
        (DVec3::new(1.0, 1.0, 0.0), DVec3::new(0.0, 0.6, 0.8)),
        (DVec3::new(0.0, 4.0, 0.0), DVec3::X),
        (DVec3::ZERO, DVec3::new(half, 0.0, half)),
    ];
    assert_eq!(mesh.triangle_normals.len(), 2);
    let corners = mesh.triangles.as_flattened().iter();
    for (&place, &normal) in corners.zip(mesh.triangle_normals.as_flattened()) {
        let found = (
            mesh.positions[place as usize],
            mesh.normals[normal as usize],
        );
        let near = |n: &(DVec3, DVec3)| n.0 == found.0 && n.1.distance(found.1) < 1e-15;
        assert!(normals.iter().any(near), "{found:?}");
    }
}

#[test]
fn a_triangle_without_usable_normals_is_flat() {
    let smooth = "vn 0 0.6 0.8\nf 1//1 2//1 3//1\n";
    for (normal, face) in [
        ("vn 0 0 0", "f 1//1 2//2 3//1"),
        ("vn nan 0 0", "f 1//1 2//2 3//1"),
        ("vn inf 0 0", "f 1//2 2//1 3//1"),
        ("vn 1 0 0", "f 1 2 3"),
        ("vn 1 0 0", "f 1//1 2 3//2"),
    ] {
        let file = read(format!("{TRIANGLE}{smooth}{normal}\n{face}\n{smooth}"));
        assert_sound(&file);
        let of = |t: usize| file.mesh.triangle_normals[t].map(|n| file.mesh.normals[n as usize]);
        assert_eq!(of(1), [DVec3::Z; 3], "{face}");
        for other in [of(0), of(2)] {
            assert!(
                other
                    .iter()
                    .all(|n| n.distance(DVec3::new(0.0, 0.6, 0.8)) < 1e-15)
            );
        }
        // Without any other, the mesh has no normals at all.
        let alone = read(format!("{TRIANGLE}vn 0 0.6 0.8\n{normal}\n{face}\n")).mesh;
        assert!(alone.normals.is_empty() && alone.triangle_normals.is_empty());
    }
}

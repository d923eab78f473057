use super::check::{
    closer_than, doubles, euler_characteristic, fault, least_cosine, mirrored_uvs, open_edges,
    volume,
};
use super::*;

const CLOSED: [Builtin; 4] = [
    Builtin::Icosphere,
    Builtin::Knot,
    Builtin::Box,
    Builtin::Tetrahedron,
];

/// The triangle counts that a form with one number allows.
fn counts(kind: Builtin) -> Option<Vec<u64>> {
    let of = |least: u64, count: fn(u64) -> u64| Some((least..200).map(count).collect());
    match kind {
        Builtin::Teapot => of(2, |n| 64 * n * n - 8 * n),
        Builtin::Icosphere => of(1, |n| 20 * n * n),
        Builtin::Terrain => of(1, |n| 2 * n * n),
        Builtin::Box => of(1, |n| 12 * n * n),
        Builtin::Tetrahedron => of(1, |n| 4 * n * n),
        Builtin::Knot => None,
    }
}

fn details() -> impl Iterator<Item = u32> {
    (4..=100).chain([0, 1, 150, 500, 2464, 6320, 10_000, 40_000])
}

#[test]
fn names_lead_back() {
    for kind in Builtin::ALL {
        assert_eq!(Builtin::from_name(kind.name()), Some(kind));
        assert!(!kind.describe().is_empty());
    }
    assert_eq!(Builtin::from_name("Teapot"), None);
    assert_eq!(Builtin::from_name(""), None);
}

#[test]
fn the_count_is_the_nearest_one() {
    for kind in Builtin::ALL {
        let Some(counts) = counts(kind) else { continue };
        for detail in details() {
            let count = build(kind, detail).triangles.len() as u64;
            assert!(counts.contains(&count), "{kind:?} {detail}: {count}");
            let miss = |c: u64| c.abs_diff(u64::from(detail));
            let best = counts.iter().copied().map(miss).min();
            assert_eq!(Some(miss(count)), best, "{kind:?} {detail}: {count}");
        }
    }
}

#[test]
fn known_counts() {
    let count = |kind, detail| build(kind, detail).triangles.len();
    assert_eq!(count(Builtin::Teapot, 6320), 6320);
    assert_eq!(count(Builtin::Teapot, 2464), 2256);
    for kind in Builtin::ALL {
        let detail = kind.default_detail();
        assert_eq!(count(kind, detail), detail as usize, "{kind:?}");
    }
}

#[test]
fn nearest_takes_the_smaller_on_a_tie_and_keeps_the_least() {
    let square = |n: u64| 2 * n * n;
    assert_eq!(nearest(5, 1, square), 1); // 2 and 8 are 3 away
    assert_eq!(nearest(6, 1, square), 2);
    assert_eq!(nearest(0, 3, square), 3);
    assert_eq!(nearest(u32::MAX, 1, square), 46341);
}

#[test]
fn every_mesh_is_sound_at_every_detail() {
    for kind in Builtin::ALL {
        for detail in details() {
            let mesh = build(kind, detail);
            assert_eq!(fault(&mesh), None, "{kind:?} {detail}");
            // The teapot's own tests say what it has of both.
            if kind != Builtin::Teapot {
                assert_eq!(doubles(&mesh), [[0; 2]; 0], "{kind:?} {detail}");
                assert!(least_cosine(&mesh) > 0.0, "{kind:?} {detail}");
            }
        }
    }
}

#[test]
fn textures_are_seen_from_the_front_and_cover_the_square() {
    for kind in Builtin::ALL {
        for detail in details() {
            let mesh = build(kind, detail);
            if [Builtin::Icosphere, Builtin::Tetrahedron].contains(&kind) {
                assert!(mesh.uvs.is_empty() && mesh.triangle_uvs.is_empty());
                continue;
            }
            assert_eq!(mirrored_uvs(&mesh), 0, "{kind:?} {detail}");
            let largest = if kind == Builtin::Teapot { 4.0 } else { 1.0 };
            let inside = |uv: &[f64; 2]| uv.iter().all(|x| (0.0..=largest).contains(x));
            assert!(mesh.uvs.iter().all(inside), "{kind:?} {detail}");
            for corner in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]] {
                assert!(mesh.uvs.contains(&corner), "{kind:?} {detail} {corner:?}");
            }
        }
    }
    let mut turned = build(Builtin::Knot, 500);
    turned.triangle_uvs[7].swap(0, 1);
    assert_eq!(mirrored_uvs(&turned), 1);
}

#[test]
fn on_a_box_v_is_up_and_a_step_is_a_step() {
    let mesh = build(Builtin::Box, 12 * 7 * 7);
    for (triangle, uvs) in mesh.triangles.iter().zip(&mesh.triangle_uvs) {
        let places = triangle.map(|i| mesh.positions[i as usize]);
        let uvs = uvs.map(|i| glam::DVec2::from(mesh.uvs[i as usize]));
        for (from, to) in [(0, 1), (1, 2)] {
            let (way, way_uv) = (places[to] - places[from], uvs[to] - uvs[from]);
            // Two roundings of numbers up to 1.
            let slack = 4.0 * f64::EPSILON;
            assert!((way.length() - way_uv.length()).abs() <= slack);
            let stands = places.iter().all(|p| p.x == places[0].x)
                || places.iter().all(|p| p.z == places[0].z);
            assert!(!stands || (way.y - way_uv.y).abs() <= slack);
        }
    }
}

#[test]
fn closed_forms_are_closed_and_wound_outward() {
    for kind in CLOSED {
        let euler = if kind == Builtin::Knot { 0 } else { 2 };
        for detail in details() {
            let mesh = build(kind, detail);
            assert_eq!(open_edges(&mesh), 0, "{kind:?} {detail}");
            assert_eq!(euler_characteristic(&mesh), euler, "{kind:?} {detail}");
            assert!(volume(&mesh) > 0.0, "{kind:?} {detail}");
        }
    }
}

#[test]
fn normals_are_those_of_the_surface() {
    // Where normals are the surface's, their angle to the facets goes with the
    // length of an edge: 1 - cosine falls 16 times with 16 times the triangles.
    // Half of that is left for the split that is not quite the same.
    for kind in [Builtin::Icosphere, Builtin::Knot, Builtin::Teapot] {
        let miss = |detail| 1.0 - least_cosine(&build(kind, detail));
        let [coarse, fine] = [miss(30_000), miss(480_000)];
        assert!(8.0 * fine < coarse, "{kind:?}: {coarse} {fine}");

        let mut leaning = build(kind, 480_000);
        let lean = |n: &mut glam::DVec3| *n = (*n + 0.3 * glam::DVec3::X).normalize();
        leaning.normals.iter_mut().for_each(lean);
        assert!(8.0 * (1.0 - least_cosine(&leaning)) > coarse, "{kind:?}");
    }
}

#[test]
fn volumes_and_sizes() {
    let relative = |a: f64, b: f64| (a / b - 1.0).abs();
    // Flat forms: exact up to the rounding of some thousand sums.
    let cube = build(Builtin::Box, 1000);
    assert!(relative(volume(&cube), 1.0) < 1000.0 * f64::EPSILON);
    let tetrahedron = build(Builtin::Tetrahedron, 1000);
    let regular = 8.0 * 3.0_f64.sqrt() / 27.0;
    assert!(relative(volume(&tetrahedron), regular) < 1000.0 * f64::EPSILON);
    let longest = tetrahedron.positions.iter().map(|p| p.length());
    assert!(relative(longest.fold(0.0, f64::max), 1.0) < 4.0 * f64::EPSILON);

    // Between three points of a unit sphere at edge s the flat triangle lies s^2/8
    // deeper than the sphere on average, a share of 3 s^2/8 of the volume. An
    // edge is at most 1.0515/n, stretched by 1/0.7947 (see below).
    let n = 20.0;
    let sphere = volume(&build(Builtin::Icosphere, 20 * 20 * 20));
    let ball = 4.0 / 3.0 * std::f64::consts::PI;
    assert!(sphere < ball);
    assert!(relative(sphere, ball) < (1.0515_f64 / 0.7947 / n).powi(2) * 3.0 / 8.0);
}

#[test]
fn flat_faces_stay_flat() {
    for p in build(Builtin::Box, 12 * 7 * 7).positions {
        let on_faces = p.to_array().into_iter().filter(|c| c.abs() == 0.5).count();
        assert!(on_faces >= 1 && p.abs().max_element() == 0.5, "{p}");
    }
    assert!(build(Builtin::Box, 12).normals.is_empty());
    assert!(build(Builtin::Tetrahedron, 4).normals.is_empty());
}

#[test]
fn icosphere_vertices_keep_apart() {
    // The icosahedron's edge is 1.0515 and its inradius 0.7947; pushing a point
    // of a face outward shortens no distance below 0.7947 of it, seen as an
    // angle. Half of that covers chord against arc and pairs across an edge.
    for n in [1, 2, 5, 30] {
        let bound = 0.5 * 0.7947 * 1.0515 / f64::from(n);
        let mesh = build(Builtin::Icosphere, 20 * n * n);
        assert_eq!(closer_than(&mesh, bound), None, "n = {n}");
        assert!(closer_than(&mesh, 4.0 * bound).is_some(), "n = {n}");
    }
}

#[test]
fn terrain_is_one_sheet_and_the_same_form_at_each_detail() {
    let coarse = build(Builtin::Terrain, 2 * 10 * 10);
    let fine = build(Builtin::Terrain, 2 * 40 * 40);
    assert_eq!(open_edges(&coarse), 40);
    assert_eq!(euler_characteristic(&coarse), 1);
    assert!(coarse.normals.iter().all(|n| n.y > 0.0));
    let span = |axis: fn(&glam::DVec3) -> f64| {
        let values = fine.positions.iter().map(axis);
        values.fold((f64::MAX, f64::MIN), |(a, b), v| (a.min(v), b.max(v)))
    };
    assert_eq!(span(|p| p.x), (-5.0, 5.0));
    assert_eq!(span(|p| p.z), (-5.0, 5.0));
    let (low, high) = span(|p| p.y);
    assert!(low > -3.0 && high < 3.0 && high - low > 0.5, "{low} {high}");
    let shared = coarse
        .positions
        .iter()
        .filter(|p| fine.positions.contains(p));
    // x and z are rounded once in each mesh; most come out the same.
    assert!(shared.count() > coarse.positions.len() / 2);
}

#[test]
fn the_checks_can_fail() {
    for kind in CLOSED {
        let good = build(kind, 500);

        let mut flipped = good.clone();
        flipped.triangles[7].swap(0, 1);
        assert!(
            fault(&flipped).is_some_and(|f| f.contains("run twice")),
            "{kind:?}"
        );
        assert_ne!(open_edges(&flipped), 0);

        let mut inside_out = good.clone();
        inside_out.triangles.iter_mut().for_each(|t| t.swap(0, 1));
        assert!(volume(&inside_out) < 0.0);

        let mut holed = good.clone();
        holed.triangles.pop();
        assert_eq!(open_edges(&holed), 3);
        assert_ne!(euler_characteristic(&holed), euler_characteristic(&good));

        // One corner torn from its neighbours, by one ulp.
        let mut torn = good.clone();
        let mut corner = torn.positions[torn.triangles[7][0] as usize];
        corner.x = corner.x.next_up();
        torn.triangles[7][0] = torn.positions.len() as u32;
        torn.positions.push(corner);
        assert_eq!(open_edges(&torn), 4, "{kind:?}");
        // The same corner, not moved: closed, but not shared.
        *torn.positions.last_mut().unwrap() = good.positions[good.triangles[7][0] as usize];
        assert_eq!(open_edges(&torn), 0, "{kind:?}");
        assert_eq!(doubles(&torn).len(), 1, "{kind:?}");

        let mut wild = good.clone();
        wild.positions[0].y = f64::NAN;
        assert!(fault(&wild).is_some_and(|f| f.contains("finite")));

        let mut untextured = good.clone();
        untextured.triangle_uvs = vec![[0; 3]];
        untextured.uvs = vec![[0.0; 2]];
        assert!(fault(&untextured).is_some_and(|f| f.contains("not all")));
        untextured.triangle_uvs = vec![[0, 0, 1]; good.triangles.len()];
        assert!(fault(&untextured).is_some_and(|f| f.contains("no texture coordinates 1")));
        untextured.uvs.push([0.0, f64::INFINITY]);
        assert!(fault(&untextured).is_some_and(|f| f.contains("not finite")));

        let mut thin = good.clone();
        let [a, b, c] = thin.triangles[7].map(|i| i as usize);
        thin.positions[c] = (thin.positions[a] + thin.positions[b]) / 2.0;
        assert!(
            fault(&thin).is_some_and(|f| f.contains("no area")),
            "{kind:?}"
        );
    }
    let mut turned = build(Builtin::Icosphere, 500);
    turned.normals[3] = -turned.normals[3];
    assert!(least_cosine(&turned) < 0.0);
    turned.normals[3] *= 1.000_001;
    assert!(fault(&turned).is_some_and(|f| f.contains("has length")));
}

#[test]
fn more_than_the_most_is_the_most() {
    let count = build(Builtin::Tetrahedron, u32::MAX).triangles.len();
    assert_eq!(count, 4 * 1581 * 1581); // 4 * 1582^2 is farther from 10 million
}

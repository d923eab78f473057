use glam::{DQuat, DVec3};
use proptest::prelude::*;

use super::{Clipper, Cut, MAX_CLIPPED_CORNERS, newell_normal};

fn flat(corners: &[(f64, f64)]) -> Vec<DVec3> {
    corners
        .iter()
        .map(|&(x, y)| DVec3::new(x, y, 0.0))
        .collect()
}

fn cut(corners: &[DVec3]) -> (Cut, Vec<[usize; 3]>) {
    let mut clipper = Clipper::default();
    let cut = clipper.cut(corners);
    (cut, clipper.triangles().to_vec())
}

fn fan(corners: &[DVec3]) -> Vec<[usize; 3]> {
    (1..corners.len() - 1).map(|i| [0, i, i + 1]).collect()
}

/// Sum of the triangles' areas without sign, and the least signed area, both
/// over the polygon's area.
fn areas(corners: &[DVec3], triangles: &[[usize; 3]]) -> (f64, f64) {
    let normal = newell_normal(corners);
    let area = normal.length();
    let signed = |t: &[usize; 3]| {
        let cross = (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]);
        (cross.length(), cross.dot(normal) / area)
    };
    let sum: f64 = triangles.iter().map(|t| signed(t).0).sum();
    let least = triangles
        .iter()
        .map(|t| signed(t).1)
        .fold(f64::MAX, f64::min);
    (sum / area, least / area)
}

/// Cut by ears, of the polygon's area, none reversed or empty.
fn assert_proper(corners: &[DVec3]) {
    let (how, triangles) = cut(corners);
    assert_eq!(how, Cut::Ears, "{corners:?}");
    assert_eq!(triangles.len(), corners.len() - 2, "{corners:?}");
    let (sum, least) = areas(corners, &triangles);
    assert!((sum - 1.0).abs() < rounding(corners), "{sum} {corners:?}");
    assert!(least > -rounding(corners), "{least} {corners:?}");
}

/// Bound on the relative error of an area: each of n cross products errs by a
/// few rounding units of (magnitude * size), here over the area.
fn rounding(corners: &[DVec3]) -> f64 {
    let magnitude = corners
        .iter()
        .map(|c| c.abs().max_element())
        .fold(0.0, f64::max);
    let size = corners
        .iter()
        .map(|c| (*c - corners[0]).length())
        .fold(0.0, f64::max);
    let area = newell_normal(corners).length();
    corners.len() as f64 * 16.0 * f64::EPSILON * (magnitude + size) * size / area
}

const DART: [(f64, f64); 4] = [(0.0, 0.0), (4.0, 0.0), (1.0, 1.0), (0.0, 4.0)];

/// A square with a square hole, joined by a bridge from corner 3 to 4.
const RING: [(f64, f64); 10] = [
    (0.0, 0.0),
    (6.0, 0.0),
    (6.0, 6.0),
    (0.0, 6.0),
    (0.0, 0.0),
    (2.0, 2.0),
    (2.0, 4.0),
    (4.0, 4.0),
    (4.0, 2.0),
    (2.0, 2.0),
];

#[test]
fn a_convex_polygon_becomes_the_fan_from_its_first_corner() {
    for count in [3, 4, 5, 12, 2 * MAX_CLIPPED_CORNERS] {
        let turn = std::f64::consts::TAU / count as f64;
        let round = |i: usize| ((turn * i as f64).cos(), (turn * i as f64).sin());
        let corners = flat(&(0..count).map(round).collect::<Vec<_>>());
        assert_eq!(cut(&corners), (Cut::Ears, fan(&corners)));
    }
}

#[test]
fn a_concave_polygon_is_cut_from_any_corner_and_in_either_winding() {
    for shape in [&DART[..], &RING[..]] {
        for shift in 0..shape.len() {
            let mut corners = flat(shape);
            corners.rotate_left(shift);
            assert_proper(&corners);
            corners.reverse();
            assert_proper(&corners);
        }
    }
}

#[test]
fn the_area_check_can_fail() {
    let mut corners = flat(&DART);
    corners.rotate_left(1);
    let (sum, least) = areas(&corners, &fan(&corners));
    assert!(sum > 1.1 && least < -0.1, "{sum} {least}");
}

#[test]
fn collinear_corners_are_kept_without_empty_triangles() {
    let shape = [
        (0.0, 0.0),
        (1.0, 0.0),
        (2.0, 0.0),
        (2.0, 1.0),
        (2.0, 2.0),
        (1.0, 2.0),
        (0.0, 2.0),
        (0.0, 1.0),
    ];
    let triangle = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.0), (0.0, 3.0)];
    for shape in [&shape[..], &triangle[..]] {
        for shift in 0..shape.len() {
            let mut corners = flat(shape);
            corners.rotate_left(shift);
            assert_proper(&corners);
            let (_, triangles) = cut(&corners);
            let (_, least) = areas(&corners, &triangles);
            assert!(least > 0.0, "{least}");
        }
    }
}

#[test]
fn no_area_is_nothing() {
    let line = flat(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]);
    assert_eq!(cut(&line).0, Cut::Nothing);
    assert_eq!(cut(&line[..3]).0, Cut::Nothing);
    let there_and_back = flat(&[(0.0, 0.0), (1.0, 0.0), (0.0, 0.0), (1.0, 0.0)]);
    assert_eq!(cut(&there_and_back).0, Cut::Nothing);
}

#[test]
fn a_polygon_that_crosses_itself_becomes_a_fan() {
    let corners = flat(&[(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 2.0)]);
    assert_eq!(cut(&corners), (Cut::Fan, fan(&corners)));
    let with_spike = flat(&[
        (0.0, 0.0),
        (2.0, 0.0),
        (2.0, 2.0),
        (2.0, 5.0),
        (2.0, 2.0),
        (0.0, 2.0),
    ]);
    assert_eq!(cut(&with_spike).0, Cut::Fan);
}

#[test]
fn a_huge_concave_polygon_does_not_take_quadratic_time() {
    let count = 2 * MAX_CLIPPED_CORNERS;
    let turn = std::f64::consts::TAU / count as f64;
    let star = |i: usize| {
        let radius = if i.is_multiple_of(2) { 1.0 } else { 2.0 };
        (
            (turn * i as f64).cos() * radius,
            (turn * i as f64).sin() * radius,
        )
    };
    let corners = flat(&(0..count).map(star).collect::<Vec<_>>());
    assert_eq!(cut(&corners).0, Cut::Fan);
    assert_proper(&flat(
        &(0..64)
            .map(|i| star(i * count / 64 + i % 2))
            .collect::<Vec<_>>(),
    ));
}

/// A polygon that is star-shaped about its centre, turned and moved in space.
fn star_shaped() -> impl Strategy<Value = Vec<DVec3>> {
    let radii = prop::collection::vec(0.05f64..1.0, 4..40);
    let axis = prop::array::uniform3(-1.0f64..1.0);
    let centre = prop::array::uniform3(-100.0f64..100.0);
    (radii, axis, 0.0f64..6.3, centre, -6i32..6, any::<bool>()).prop_map(
        |(radii, axis, angle, centre, scale, reversed)| {
            let axis = DVec3::from(axis).try_normalize().unwrap_or(DVec3::X);
            let turn = DQuat::from_axis_angle(axis, angle);
            let step = std::f64::consts::TAU / radii.len() as f64;
            let corner = |(i, radius): (usize, &f64)| {
                let around = step * i as f64;
                let place = DVec3::new(around.cos(), around.sin(), 0.0) * *radius;
                (turn * place + DVec3::from(centre)) * 10f64.powi(scale)
            };
            let mut corners: Vec<_> = radii.iter().enumerate().map(corner).collect();
            if reversed {
                corners.reverse();
            }
            corners
        },
    )
}

/// A strip with holes in a row. Each is joined by a bridge to the top edge, or
/// all are to one corner; the bridges have no width.
fn strip_with_holes() -> impl Strategy<Value = Vec<DVec3>> {
    let hole = prop::collection::vec(0.1f64..0.9, 3..9);
    let holes = prop::collection::vec(hole, 1..5);
    (holes, any::<bool>(), 0usize..60).prop_map(|(holes, one_corner, shift)| {
        let right = 2.0 * holes.len() as f64;
        let far_corner = (right + 1.0, 9.0);
        let mut corners = vec![(-1.0, -1.0), (right + 1.0, -1.0), far_corner];
        for (i, radii) in holes.iter().enumerate().rev() {
            let step = std::f64::consts::TAU / radii.len() as f64;
            let centre = 2.0 * i as f64 + 1.0;
            // Clockwise, from the top and back to it.
            let at = |k: usize| {
                let radius = if k == 0 { 0.95 } else { radii[k] };
                let around = step * k as f64;
                (centre + radius * around.sin(), radius * around.cos())
            };
            let rim = (0..radii.len()).chain([0]).map(at);
            let anchor = if one_corner {
                far_corner
            } else {
                (centre, 9.0)
            };
            if !one_corner {
                corners.push(anchor);
            }
            corners.extend(rim);
            corners.push(anchor);
        }
        corners.push((-1.0, 9.0));
        let shift = shift % corners.len();
        corners.rotate_left(shift);
        flat(&corners)
    })
}

proptest! {
    #[test]
    fn star_shaped_polygons_keep_area_and_orientation(corners in star_shaped()) {
        assert_proper(&corners);
    }

    #[test]
    fn holes_stay_open(corners in strip_with_holes()) {
        assert_proper(&corners);
    }

    /// Whatever the corners: every index is one, and no more than n - 2.
    #[test]
    fn garbage_is_cut_without_panic(
        grid in prop::collection::vec(prop::array::uniform3(-2i32..3), 3..12)
    ) {
        let corners: Vec<_> = grid.iter().map(|&g| DVec3::from(g.map(f64::from))).collect();
        let (how, triangles) = cut(&corners);
        prop_assert!(triangles.len() <= corners.len() - 2);
        prop_assert!(triangles.as_flattened().iter().all(|&i| i < corners.len()));
        prop_assert_eq!(how == Cut::Nothing, triangles.is_empty());
    }
}

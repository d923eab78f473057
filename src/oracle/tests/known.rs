//! Cases whose answer whole numbers tell.

use super::{Shapes, ray};
use crate::layout::NO_HIT;
use crate::oracle::Truth;

const ORIGIN: [f64; 3] = [0.0; 3];
const AHEAD: [f64; 3] = [0.0, 0.0, 1.0];

fn hit(shapes: &Shapes, origin: [f64; 3], direction: [f64; 3]) -> Truth {
    shapes.oracle().closest(ray(origin, direction))
}

#[track_caller]
fn assert_hit(truth: Truth, id: u32, t: f64) {
    assert_eq!((truth.id, truth.t), (id, t), "{truth:?}");
}

#[track_caller]
fn assert_missed(truth: Truth) {
    assert_hit(truth, NO_HIT, f64::INFINITY);
}

#[test]
fn a_tangent_hits_and_one_ulp_turns_it() {
    // (3, 4, 0) is 5 from the axis.
    let tangent = |radius| Shapes::none().sphere([3.0, 4.0, 1e6], radius);
    assert_hit(hit(&tangent(5.0), ORIGIN, AHEAD), 0, 1e6);
    assert_eq!(hit(&tangent(5.0), ORIGIN, AHEAD).margin, 0.0);
    assert_missed(hit(&tangent(5_f64.next_down()), ORIGIN, AHEAD));
    let inside = hit(&tangent(5_f64.next_up()), ORIGIN, AHEAD);
    assert_eq!(inside.id, 0);
    // r^2 is larger by 10 ulp of 5, so t is smaller by the root of that.
    let half_chord = (10.0 * 2_f64.powi(-50)).sqrt();
    let nearer = (1e6 - inside.t) - inside.t_rest;
    assert!((nearer / half_chord - 1.0).abs() < 1e-14, "{inside:?}");
}

#[test]
fn a_sphere_from_without_within_and_upon() {
    let sphere = Shapes::none().sphere([0.0, 0.0, 10.0], 2.0);
    assert_hit(hit(&sphere, ORIGIN, AHEAD), 0, 8.0);
    assert_hit(hit(&sphere, ORIGIN, [0.0, 0.0, 4.0]), 0, 2.0);
    assert_missed(hit(&sphere, ORIGIN, [0.0, 0.0, -1.0]));
    // At the centre, and off it.
    assert_hit(hit(&sphere, [0.0, 0.0, 10.0], [0.0, 3.0, 4.0]), 0, 0.4);
    assert_hit(hit(&sphere, [0.0, 0.0, 11.0], AHEAD), 0, 1.0);
    assert_hit(hit(&sphere, [0.0, 0.0, 9.0], AHEAD), 0, 3.0);
    // On the surface: outward, along it, inward.
    assert_missed(hit(&sphere, [0.0, 0.0, 8.0], [0.0, 0.0, -1.0]));
    assert_missed(hit(&sphere, [0.0, 0.0, 8.0], [1.0, 0.0, 0.0]));
    assert_hit(hit(&sphere, [0.0, 0.0, 8.0], AHEAD), 0, 4.0);
    // An ulp within, outward: t is that ulp.
    let within = 8_f64.next_up();
    let out = hit(&sphere, [0.0, 0.0, within], [0.0, 0.0, -1.0]);
    assert_hit(out, 0, within - 8.0);
}

#[test]
fn an_inexact_t_comes_with_its_rest() {
    // 0.4 is so many times 2^-54, and what 5 times it lacks of 2 is whole.
    let sphere = Shapes::none().sphere([0.0, 0.0, 10.0], 2.0);
    let truth = hit(&sphere, [0.0, 0.0, 10.0], [0.0, 3.0, 4.0]);
    let unit = 2_f64.powi(-54);
    let lacking = (2_i64 << 54) - 5 * (0.4 / unit) as i64;
    assert!(lacking != 0);
    assert_eq!(truth.t_rest, lacking as f64 / 5.0 * unit);
    // t is 8 - root 3. What the f64 of root 3 lacks is a step of Newton's, whose numerator is
    // whole.
    let truth = hit(&sphere, [0.0, 1.0, 2.0], AHEAD);
    let root = (3_f64.sqrt() * 2_f64.powi(52)) as i128;
    let short = (3_i128 << 104) - root * root;
    let root_rest = short as f64 / (2.0 * root as f64) * 2_f64.powi(-52);
    let known = (8.0 - truth.t) - 3_f64.sqrt() - root_rest;
    assert!((truth.t_rest - known).abs() < 1e-31, "{truth:?} {known}");
}

#[test]
fn far_spheres_and_huge_ones() {
    let far = |radius| Shapes::none().sphere([0.6, 0.0, 1e6], radius);
    assert_hit(hit(&far(1.0), ORIGIN, AHEAD), 0, 1e6 - 0.8);
    assert_missed(hit(&far(0.6_f64.next_down()), ORIGIN, AHEAD));
    assert_hit(hit(&far(0.6), ORIGIN, AHEAD), 0, 1e6);
    // From 2 above a planet: straight down, to the horizon, and a little above it.
    let planet = Shapes::none().sphere([0.0, -6_371_002.0, 0.0], 6_371_000.0);
    assert_hit(hit(&planet, ORIGIN, [0.0, -1.0, 0.0]), 0, 2.0);
    // Tangent^2 = 6371002^2 - 6371000^2 = 2 * 12742002; sin of the dip = root of it / D.
    let horizon = 25_484_004_f64.sqrt();
    assert_eq!(
        hit(&planet, ORIGIN, [6_371_000.0, -horizon.next_up(), 0.0]).id,
        0
    );
    assert_missed(hit(
        &planet,
        ORIGIN,
        [6_371_000.0, -horizon.next_down(), 0.0],
    ));
}

#[test]
fn planes() {
    let plane = Shapes::none().plane([0.0, 0.0, 3.0], [0.0, 0.0, -7.0]);
    assert_hit(hit(&plane, ORIGIN, AHEAD), 0, 3.0);
    assert_hit(hit(&plane, [0.0, 0.0, 5.0], [0.0, 0.0, -2.0]), 0, 1.0);
    assert_missed(hit(&plane, ORIGIN, [0.0, 0.0, -1.0]));
    assert_missed(hit(&plane, ORIGIN, [1.0, 2.0, 0.0]));
    assert_missed(hit(&plane, [0.0, 0.0, 3.0], AHEAD));
    // In the plane.
    assert_missed(hit(&plane, [0.0, 0.0, 3.0], [1.0, 0.0, 0.0]));
    // The slope is one ulp of what cancels in it: 1 * 1 - (1 - 2^-53) * 1.
    let slanted = Shapes::none().plane([0.0, 0.0, 1.0], [1.0, 0.0, 1.0]);
    let grazing = hit(&slanted, ORIGIN, [-1_f64.next_down(), 0.0, 1.0]);
    assert_hit(grazing, 0, 2_f64.powi(53));
    assert_missed(hit(&slanted, ORIGIN, [-1.0, 0.0, 1.0]));
}

#[test]
fn a_t_that_is_known_poorly_at_first_may_be_the_nearest() {
    // What is added up to 4 goes through 2^30, so f64 does not know the last 2^-22.
    let walls = |z| {
        Shapes::none()
            .plane([0.0, 0.0, 4.0], [0.0, 0.0, 1.0])
            .plane([2_f64.powi(30), 2_f64.powi(30), z], [1.0, -1.0, 1.0])
    };
    let off = 2_f64.powi(-30);
    assert_hit(hit(&walls(4.0 - off), ORIGIN, AHEAD), 1, 4.0 - off);
    assert_hit(hit(&walls(4.0), ORIGIN, AHEAD), 0, 4.0);
    assert_hit(hit(&walls(4.0 + off), ORIGIN, AHEAD), 0, 4.0);
}

#[test]
fn a_t_next_to_the_middle_of_two_f64_is_rounded_right() {
    // 1 + 2^-53 is the middle; 2^-110 beside it is more than two f64 hold.
    let beside = |small: f64| {
        let [middle, factor] = [2_f64.powi(-53), 2_f64.powi(-50)];
        Shapes::none().plane([middle, factor, 1.0], [1.0, small, 1.0])
    };
    let small = 2_f64.powi(-60);
    let rest = 2_f64.powi(-53);
    let above = hit(&beside(small), ORIGIN, AHEAD);
    assert_eq!((above.t, above.t_rest), (1_f64.next_up(), -rest));
    let below = hit(&beside(-small), ORIGIN, AHEAD);
    assert_eq!((below.t, below.t_rest), (1.0, rest));
}

#[test]
fn the_rim_belongs_to_a_disk() {
    let disk = |radius: f64| Shapes::none().disk([3.0, 4.0, 2.0], [0.0, 0.0, 1.0], radius);
    assert_hit(hit(&disk(5.0), ORIGIN, AHEAD), 0, 2.0);
    assert_missed(hit(&disk(5_f64.next_down()), ORIGIN, AHEAD));
    assert_hit(hit(&disk(5_f64.next_up()), ORIGIN, AHEAD), 0, 2.0);
    assert_missed(hit(&disk(5.0), ORIGIN, [0.0, 0.0, -1.0]));
    assert_missed(hit(&disk(5.0), [0.0, 0.0, 2.0], [1.0, 1.0, 0.0]));
    // Slanted, by a normal of no unit length: (1, 2, 2) is 3 long, and (3, 4, z) is on the
    // plane through the origin for z = -5.5.
    let slanted = Shapes::none().disk(ORIGIN, [1.0, 2.0, 2.0], 55.25_f64.sqrt().next_up());
    assert_hit(hit(&slanted, [3.0, 4.0, -8.5], AHEAD), 0, 3.0);
    let small = Shapes::none().disk(ORIGIN, [1.0, 2.0, 2.0], 55.25_f64.sqrt().next_down());
    assert_missed(hit(&small, [3.0, 4.0, -8.5], AHEAD));
}

const SQUARE: [[f64; 3]; 4] = [
    [0.0, 0.0, 4.0],
    [3.0, 0.0, 4.0],
    [3.0, 3.0, 4.0],
    [0.0, 3.0, 4.0],
];

#[test]
fn edges_and_corners_belong_to_a_triangle() {
    let [a, b, c, d] = SQUARE;
    let square = Shapes::none().triangle([a, b, c]).triangle([a, c, d]);
    let at = |x, y| hit(&square, [x, y, 1.0], AHEAD);
    // The shared edge and its ends are the first one's; an ulp beyond is the other's.
    for on_both in [0.0, 1.0, 0.1, 2.9, 3.0] {
        assert_hit(at(on_both, on_both), 0, 3.0);
        assert_eq!(at(on_both, on_both).margin, 0.0);
    }
    assert_hit(at(1.0, 1_f64.next_up()), 1, 3.0);
    assert_hit(at(1.0, 1_f64.next_down()), 0, 3.0);
    assert_hit(at(3.0, 1.0), 0, 3.0);
    assert_missed(at(3_f64.next_up(), 1.0));
    assert_missed(at(1.0, -f64::MIN_POSITIVE));
    // Edges seen aslant: from a point to one of an edge, in whole numbers.
    let aslant = |x, y| hit(&square, [-5.0, 7.0, 1.0], [x + 5.0, y - 7.0, 3.0]);
    assert_hit(aslant(2.0, 2.0), 0, 1.0);
    assert_hit(aslant(0.0, 3.0), 1, 1.0);
    assert_hit(aslant(0.0, 0.0), 0, 1.0);
    // From behind, and with the corners in any order.
    for corners in [
        [a, b, c],
        [b, c, a],
        [c, a, b],
        [a, c, b],
        [c, b, a],
        [b, a, c],
    ] {
        let one = Shapes::none().triangle(corners);
        assert_hit(hit(&one, [2.0, 2.0, 1.0], AHEAD), 0, 3.0);
        assert_hit(hit(&one, [2.0, 1.0, 6.0], [0.0, 0.0, -2.0]), 0, 1.0);
        assert_missed(hit(&one, [2.0, 2_f64.next_up(), 1.0], AHEAD));
        assert_missed(hit(&one, [2.0, 1.0, 4.0], AHEAD));
    }
}

#[test]
fn what_has_no_area_is_missed() {
    let [a, b, c, _] = SQUARE;
    let in_plane = Shapes::none().triangle([a, b, c]);
    assert_missed(hit(&in_plane, [-1.0, 1.0, 4.0], [1.0, 0.0, 0.0]));
    assert_missed(hit(&in_plane, [-1.0, 0.0, 4.0], [1.0, 0.0, 0.0]));
    for corners in [[a, a, c], [a, a, a], [a, [1.0, 1.0, 4.0], c]] {
        let degenerate = Shapes::none().triangle(corners);
        assert_missed(hit(&degenerate, [1.0, 1.0, 0.0], AHEAD));
        assert_missed(hit(&degenerate, [0.0, 0.0, 0.0], AHEAD));
    }
    // The control: an ulp of width is enough to be hit.
    let sliver = Shapes::none().triangle([a, [1.0, 1_f64.next_down(), 4.0], c]);
    assert_hit(hit(&sliver, [1.0, 1.0, 0.0], AHEAD), 0, 4.0);
}

#[test]
fn of_equals_the_lowest_id_counts() {
    let [a, b, c, _] = SQUARE;
    let all = Shapes::none()
        .sphere([0.0, 0.0, 6.0], 2.0)
        .sphere([0.0, 0.0, 5.0], 1.0)
        .sphere([0.0, 0.0, 4.5], 0.5)
        .plane([0.0, 0.0, 4.0], [0.0, 0.0, 1.0])
        .plane([9.0, 9.0, 4.0], [0.0, 0.0, -3.0])
        .disk([0.0, 0.0, 4.0], [0.0, 0.0, 1.0], 1.0)
        .triangle([a, b, c])
        .triangle([a, b, c]);
    let truth = hit(&all, ORIGIN, AHEAD);
    assert_hit(truth, 0, 4.0);
    assert_eq!(truth.margin, 0.0);
    let met = all.oracle().candidates(ray(ORIGIN, AHEAD));
    assert_eq!(
        met.iter().map(|one| one.id).collect::<Vec<_>>(),
        [0, 1, 2, 3, 4, 5, 6, 7]
    );
    assert!(met.iter().all(|one| one.t == 4.0 && one.t_rest == 0.0));
    // Beside the axis only what is flat is at 4, and the planes come first.
    assert_hit(hit(&all, [0.5, 0.25, 0.0], AHEAD), 3, 4.0);
    // Of rows in another order the ids still tell.
    let mut turned = Shapes::none().triangle([a, b, c]).triangle([a, b, c]);
    turned.0.triangles.reverse();
    let truth = hit(&turned, [2.0, 1.0, 0.0], AHEAD);
    assert_eq!((truth.id, truth.row), (0, 1));
}

#[test]
fn roots_that_agree_to_many_digits_are_told_apart() {
    // Both irrational, from circles of other radii whose half chords agree: 7 + root 3 less
    // 7 for both. An ulp of one centre tells.
    let spheres = |z| {
        Shapes::none()
            .sphere([0.0, 1.0, 10.0], 2.0)
            .sphere([0.0, -1.0, z], 2.0)
    };
    assert_eq!(hit(&spheres(10.0), ORIGIN, AHEAD).id, 0);
    assert_eq!(hit(&spheres(10_f64.next_down()), ORIGIN, AHEAD).id, 1);
    assert_eq!(hit(&spheres(10_f64.next_up()), ORIGIN, AHEAD).id, 0);
    // root 3 again, from 14^2 - 193 and, doubled, not at all alike.
    let alike = Shapes::none()
        .sphere([0.0, 1.0, 10.0], 2.0)
        .sphere([12.0, 7.0, 10.0], 14.0);
    assert_eq!(hit(&alike, ORIGIN, AHEAD).margin, 0.0);
    assert_eq!(hit(&alike, ORIGIN, AHEAD).id, 0);
}

#[test]
fn the_length_of_a_direction_moves_t_alone() {
    let sphere = Shapes::none().sphere([0.25, 0.5, 10.0], 2.0);
    let reference = hit(&sphere, ORIGIN, [0.125, 0.0, 1.0]);
    for exponent in [-600, -30, -1, 1, 30, 600] {
        let factor = 2_f64.powi(exponent);
        let scaled = hit(&sphere, ORIGIN, [0.125 * factor, 0.0, factor]);
        let [t, t_rest] = [reference.t, reference.t_rest].map(|part| part / factor);
        let margin = reference.margin;
        assert_eq!(
            scaled,
            Truth {
                t,
                t_rest,
                margin,
                ..reference
            }
        );
    }
    assert_missed(hit(&sphere, ORIGIN, [0.0; 3]));
    assert!(sphere.oracle().candidates(ray(ORIGIN, [0.0; 3])).is_empty());
}

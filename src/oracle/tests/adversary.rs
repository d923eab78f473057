//! Data on which f64 decides wrongly, and the filter is to know that it does not know.

use super::widths::{Careless, errs};
use super::{Draw, Numbers, ray};
use crate::kernel::camera::Ray;
use crate::layout::{Disk, Sphere};
use crate::oracle::double::Double;
use crate::oracle::exact::Exact;
use crate::oracle::filter::Bounded;
use crate::oracle::shape::{Outcome, Shape};

/// Rays through points that f64 finds on an edge, a rim or an outline.
pub(super) fn on_adversaries(count: u32, mut check: impl FnMut(&Shape<'_>, Ray<f64>)) {
    let mut n = Numbers(5);
    for _ in 0..count {
        let corners = [n.point(10.0), n.point(10.0), n.point(10.0)];
        let weight = n.between(0.0, 1.0);
        let on_edge: [f64; 3] = std::array::from_fn(|axis| {
            corners[0][axis] + weight * (corners[1][axis] - corners[0][axis])
        });
        check(&Shape::Triangle(corners), ray([0.0; 3], on_edge));

        let center = n.point(100.0);
        let direction = n.point(1.0);
        let cross = [
            center[1] * direction[2] - center[2] * direction[1],
            center[2] * direction[0] - center[0] * direction[2],
            center[0] * direction[1] - center[1] * direction[0],
        ];
        let length = |v: [f64; 3]| v.map(|x| x * x).iter().sum::<f64>().sqrt();
        let radius = length(cross) / length(direction);
        check(
            &Shape::Sphere(&Sphere::new(center, radius)),
            ray([0.0; 3], direction),
        );

        let center = [n.between(-9.0, 9.0), n.between(-9.0, 9.0), 5.0];
        let [x, y] = [n.between(-1.0, 1.0), n.between(-1.0, 1.0)];
        let disk = Disk {
            center,
            normal: [0.0, 0.0, 1.0],
            radius: length([5.0 * x - center[0], 5.0 * y - center[1], 0.0]),
            padding: 0.0,
        };
        check(&Shape::Disk(&disk), ray([0.0; 3], [x, y, 1.0]));
    }
}

#[test]
fn the_filter_knows_its_doubts() {
    let (mut careless, mut doubts, mut double_doubts, mut hits) = (0, 0, 0, 0);
    on_adversaries(5_000, |shape, ray| {
        let is_hit = matches!(shape.decide::<Exact>(ray), Outcome::Hit(_));
        hits += u32::from(is_hit);
        assert_ne!(
            errs::<Bounded>(shape, ray, is_hit),
            Some(true),
            "{shape:?} {ray:?}"
        );
        assert_ne!(
            errs::<Double>(shape, ray, is_hit),
            Some(true),
            "{shape:?} {ray:?}"
        );
        doubts += u32::from(errs::<Bounded>(shape, ray, is_hit).is_none());
        double_doubts += u32::from(errs::<Double>(shape, ray, is_hit).is_none());
        careless += u32::from(errs::<Careless>(shape, ray, is_hit) == Some(true));
    });
    // The control: without its bound, the same arithmetic is caught. Of 15,000.
    assert!(careless > 1_000, "{careless}");
    assert!(hits > 2_000, "{hits}");
    assert!(doubts > 10_000, "{doubts}");
    assert!(double_doubts < 100, "{double_doubts}");
}

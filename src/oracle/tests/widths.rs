//! The widths agree wherever they are certain, and their bounds hold.

use std::cmp::Ordering;

use super::{Draw, Numbers, ray};
use crate::kernel::camera::Ray;
use crate::layout::{Disk, Plane, Sphere};
use crate::oracle::distance::{Distance, compare};
use crate::oracle::double::Double;
use crate::oracle::exact::Exact;
use crate::oracle::filter::Bounded;
use crate::oracle::number::{Divide, Number};
use crate::oracle::search::{exact_t, precise_t};
use crate::oracle::shape::{Outcome, Shape};

/// f64 whose bound is forgotten: the control.
#[derive(Clone)]
pub(super) struct Careless(f64);

impl Number for Careless {
    fn exact(value: f64) -> Self {
        Self(value)
    }
    fn plus(&self, other: &Self) -> Self {
        Self(self.0 + other.0)
    }
    fn minus(&self, other: &Self) -> Self {
        Self(self.0 - other.0)
    }
    fn times(&self, other: &Self) -> Self {
        Self(self.0 * other.0)
    }
    fn sign(&self) -> Option<Ordering> {
        self.0.partial_cmp(&0.0)
    }
}

/// Whether a width is certain of what is not so; none where it is in doubt.
pub(super) fn errs<N: Number>(shape: &Shape<'_>, ray: Ray<f64>, is_hit: bool) -> Option<bool> {
    match shape.decide::<N>(ray) {
        Outcome::Doubt => None,
        Outcome::Miss => Some(is_hit),
        Outcome::Hit(_) => Some(!is_hit),
    }
}

/// |x - exact| <= bound, with all of it exact.
fn is_within(exact: &Exact, parts: &[f64], bound: f64) -> bool {
    let off = parts
        .iter()
        .fold(exact.clone(), |left, part| left.minus(&Exact::exact(*part)));
    let squares = off
        .times(&off)
        .minus(&Exact::exact(bound).times(&Exact::exact(bound)));
    squares.sign() != Some(Ordering::Greater)
}

/// The bounds of t in all three widths hold.
fn check_t(shape: &Shape<'_>, ray: Ray<f64>, exact: &Distance<Exact>) {
    let truth = exact.value();
    if let Outcome::Hit(distance) = shape.decide::<Bounded>(ray) {
        let t = distance.value();
        assert!(
            !t.error.is_finite() || is_within(&truth, &[t.value], t.error),
            "{shape:?} {ray:?}"
        );
    }
    if let Outcome::Hit(distance) = shape.decide::<Double>(ray) {
        let t = distance.value();
        assert!(
            !t.error.is_finite() || is_within(&truth, &[t.high, t.low], t.error),
            "{shape:?} {ray:?}"
        );
    }
    let [t, rest] = precise_t(shape, ray);
    assert_eq!(t, exact_t(shape, ray)[0]);
    assert!(is_within(&truth, &[t, rest], t * 2_f64.powi(-80)));
}

/// Shapes of any size and distance, and rays that aim near them.
pub(super) fn on_random(count: u32, mut check: impl FnMut(&Shape<'_>, Ray<f64>)) {
    let mut n = Numbers(1);
    for index in 0..count {
        // Now and then as far as scenes go.
        let reach = if index % 5 == 0 { 14.0 } else { 4.0 };
        let size = 10_f64.powf(n.between(-reach, reach));
        let distance = size * 10_f64.powf(n.between(-1.0, 4.0));
        let center = n.point(distance);
        let origin = if index % 2 == 0 {
            [0.0; 3]
        } else {
            n.point(distance)
        };
        let offset = n.point(2.0 * size);
        let direction: [f64; 3] =
            std::array::from_fn(|axis| center[axis] + offset[axis] - origin[axis]);
        let sphere = Sphere::new(center, size);
        let normal = n.point(1.0);
        let plane = Plane {
            point: center,
            normal,
            ..Plane::default()
        };
        let disk = Disk {
            center,
            normal,
            radius: size,
            padding: 0.0,
        };
        let corners = [0; 3].map(|_| {
            let offset = n.point(2.0 * size);
            std::array::from_fn(|axis| center[axis] + offset[axis])
        });
        let ray = ray(origin, direction);
        check(&Shape::Sphere(&sphere), ray);
        check(&Shape::Plane(&plane), ray);
        check(&Shape::Disk(&disk), ray);
        check(&Shape::Triangle(corners), ray);
    }
}

#[test]
fn widths_agree_on_random_rays() {
    let (mut hits, mut certain) = (0, 0);
    on_random(10_000, |shape, ray| {
        let exact = shape.decide::<Exact>(ray);
        let is_hit = matches!(exact, Outcome::Hit(_));
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
        certain += u32::from(errs::<Bounded>(shape, ray, is_hit).is_some());
        if let Outcome::Hit(distance) = exact {
            hits += 1;
            check_t(shape, ray, &distance);
        }
    });
    // Of 40,000: neither side is empty, and the filter is of use.
    assert!((5_000..35_000).contains(&hits), "{hits}");
    assert!(certain > 39_900, "{certain}");
}

/// Next to a surface whose radius is much larger, two f64 are not enough for t.
#[test]
fn t_is_as_precise_next_to_a_huge_sphere() {
    let mut n = Numbers(10);
    let mut hits = 0;
    for _ in 0..1000 {
        let center = n.point(4e6);
        let height = 10_f64.powf(n.between(-7.0, 0.0));
        let radius = center.map(|x| x * x).iter().sum::<f64>().sqrt() - height;
        let offset = n.point(1e6);
        let direction = std::array::from_fn(|axis| center[axis] + offset[axis]);
        let sphere = Sphere::new(center, radius);
        let (shape, ray) = (Shape::Sphere(&sphere), ray([0.0; 3], direction));
        if let Outcome::Hit(distance) = shape.decide::<Exact>(ray) {
            hits += 1;
            check_t(&shape, ray, &distance);
        }
    }
    assert!(hits > 500, "{hits}");
}

/// Sums that cancel, a quotient of them, and a root.
fn formulas<N: Divide>(numbers: [f64; 4]) -> [N; 4] {
    let [x, y, z, w] = numbers.map(N::exact);
    let sum = x.times(&y).plus(&z.times(&w));
    let difference = sum.times(&x).minus(&w.times(&w));
    let squares = sum.times(&sum).plus(&x.times(&x));
    let quotient = difference.over(&squares);
    [squares.square_root(), sum, difference, quotient]
}

#[test]
fn numbers_keep_their_bounds() {
    let mut n = Numbers(2);
    let (mut bounded_beyond, mut double_beyond) = (0, 0);
    for index in 0..20_000 {
        let reach = [1.0, 12.0][index % 2];
        let numbers = [0; 4].map(|_| n.between(-1.0, 1.0) * 10_f64.powf(n.between(-reach, reach)));
        let exact = formulas::<Exact>(numbers);
        let bounded = formulas::<Bounded>(numbers);
        let double = formulas::<Double>(numbers);
        for ((exact, bounded), double) in exact.iter().zip(bounded).zip(double) {
            assert!(is_within(exact, &[bounded.value], bounded.error));
            assert!(is_within(exact, &[double.high, double.low], double.error));
            bounded_beyond += u32::from(!is_within(exact, &[bounded.value], bounded.error / 8.0));
            let parts = [double.high, double.low];
            double_beyond += u32::from(!is_within(exact, &parts, double.error / 64.0));
        }
    }
    // The control: of 80,000, many are beyond a part of the bound.
    assert!(bounded_beyond > 10_000, "{bounded_beyond}");
    assert!(double_beyond > 5_000, "{double_beyond}");
}

#[test]
fn exact_numbers_are_rounded_to_nearest() {
    let mut n = Numbers(3);
    for _ in 0..10_000 {
        let [x, y] = [n.between(-1.0, 1.0), n.between(-1.0, 1.0)];
        let [exact_x, exact_y] = [x, y].map(Exact::exact);
        assert_eq!(exact_x.nearest(), x);
        assert_eq!(exact_x.plus(&exact_y).nearest(), x + y);
        assert_eq!(exact_x.times(&exact_y).nearest(), x * y);
        assert_eq!(exact_x.over(&exact_y).nearest(), x / y);
        let size = Exact::exact(x.abs());
        assert_eq!(size.square_root().nearest(), x.abs().sqrt());
    }
    for special in [0.0, f64::MIN_POSITIVE, 5e-324, f64::MAX, -1.0] {
        assert_eq!(Exact::exact(special).to_f64(), [special, 0.0]);
    }
}

/// Distances with whole numbers and small ones, so that many are equal.
#[test]
fn comparison_orders_distances_as_their_values() {
    let mut n = Numbers(4);
    let mut distances = Vec::new();
    while distances.len() < 300 {
        let [a, b, c] = [3.0, n.whole(6), n.whole(6)];
        let discriminant = b * b - a * c;
        let exact = Exact::exact;
        let is_far = n.next().is_multiple_of(2);
        let t = if is_far {
            b + discriminant.sqrt()
        } else {
            b - discriminant.sqrt()
        } / a;
        if discriminant >= 0.0 && t > 1e-6 {
            let [a, b, c, discriminant] = [a, b, c, discriminant].map(exact);
            distances.push((
                t,
                Distance::Root {
                    a,
                    b,
                    c,
                    discriminant,
                    is_far,
                },
            ));
        }
        let [over, under] = [n.whole(9), n.whole(9)];
        if over * under > 0.0 {
            let t = over / under;
            distances.push((
                t,
                Distance::Quotient {
                    over: exact(over),
                    under: exact(under),
                },
            ));
        }
    }
    let mut equal = 0;
    for (t, first) in &distances {
        for (other_t, second) in &distances {
            // Numbers of so few digits are equal or well apart.
            let expected = if (t - other_t).abs() < 1e-9 {
                Ordering::Equal
            } else {
                t.total_cmp(other_t)
            };
            assert_eq!(compare(first, second), expected, "{first:?} {second:?}");
            equal += u32::from(expected == Ordering::Equal);
        }
    }
    assert!(equal > 1000, "{equal}");
}

//! Slivers: which are met, and where. Each test has the former formula as its control, which
//! has the edge functions for weights.

use glam::DVec3;

use super::*;
use crate::kernel::two_float::TwoFloat;
use crate::kernel::vector::dot_product;
use crate::oracle::shape::Shape;
use crate::random::Numbers;
use crate::stability::demand::unit_of;
use crate::stability::residual::{reach, residual};
use crate::tier::Accuracy;

const TRIES: u32 = 100_000;

/// In u B; see `stability::triangle`.
const ON_PLANE: f64 = 16.0;

type Corners = [[f32; 3]; 3];

fn triangle_of<R: Real>(corners: Corners) -> Triangle<R> {
    let [a, b, c] = corners.map(|corner| corner.map(constant));
    Triangle {
        a,
        padding_0: R::ZERO,
        b,
        padding_1: R::ZERO,
        c,
        padding_2: R::ZERO,
    }
}

/// The edge functions, or none where the triangle was missed.
fn edge_functions<R: Real>(seen: Seen<R>) -> Option<[R; 3]> {
    let Seen { x, y, .. } = seen;
    let products = [
        (x.z * y.y, y.z * x.y),
        (x.x * y.z, y.x * x.z),
        (x.y * y.x, y.y * x.x),
    ];
    let none_negative = products.iter().all(|(left, right)| left >= right);
    let none_positive = products.iter().all(|(left, right)| left <= right);
    let [u, v, w] = products.map(|(left, right)| left - right);
    let is_met = (none_negative || none_positive) && (u + v) + w != R::ZERO;
    is_met.then_some([u, v, w])
}

/// t by the edge functions.
fn former_t<R: Real>(ray: Ray<R>, triangle: &Triangle<R>) -> R {
    let shear = shear_of(ray);
    let seen = seen_corners(ray, shear, triangle);
    let Some([u, v, w]) = edge_functions(seen) else {
        return R::MISS;
    };
    let sum = (u + v) + w;
    let weights = vec3(u / sum, v / sum, w / sum);
    dot_product(weights, seen.along) / shear.z
}

/// A needle or a cap of length `size`, down to ten million times as long as wide, and a ray
/// from elsewhere at a point of it.
fn aimed(n: &mut Numbers, size: f64) -> (Corners, Ray<f32>) {
    let from = n.direction() * n.between(1.0, 9.0);
    let along = n.direction();
    let width = along.cross(n.direction()).normalize() * 10f64.powf(n.between(-7.0, 0.0));
    let place = if n.flip() { 1.0 } else { n.between(0.2, 0.8) };
    let corners = [from, from + along * place + width, from + along]
        .map(|corner| (corner * size).as_vec3().to_array());
    let weights = [0; 3].map(|_| n.between(0.0, 1.0));
    let sum: f64 = weights.iter().sum();
    let target: DVec3 = (0..3)
        .map(|k| DVec3::from(corners[k].map(f64::from)) * weights[k] / sum)
        .sum();
    let origin = n.direction() * n.between(0.0, 3.0) * size;
    let f32s = |v: DVec3| Vec3::from(v.as_vec3().to_array());
    let ray = Ray {
        origin: f32s(origin),
        direction: f32s(target - origin),
    };
    (corners, ray)
}

/// The most roundings by which a point is off the plane, by the formula and the former one.
fn worst<R: Real>(tier: Accuracy, size: f64) -> [f64; 2] {
    let mut n = Numbers(5);
    let mut most = [0.0, 0.0];
    let mut met = 0;
    for _ in 0..TRIES {
        let (corners, ray) = aimed(&mut n, size);
        let (triangle, exact_ray) = (triangle_of::<R>(corners), ray.converted::<f64>());
        let ray = ray.converted::<R>();
        let shape = Shape::Triangle(corners.map(|corner| corner.map(f64::from)));
        let found = [
            intersect_triangle(ray, shear_of(ray), &triangle),
            former_t(ray, &triangle),
        ];
        if found[0] == R::MISS {
            continue;
        }
        met += 1;
        for (most, t) in most.iter_mut().zip(found) {
            let t = t.to_f64();
            let scale = unit_of(tier) * reach(&shape, exact_ray, t);
            *most = f64::max(*most, residual(&shape, exact_ray, t) / scale);
        }
    }
    assert!(met > TRIES / 3, "{met}");
    most
}

#[test]
fn the_point_is_on_the_plane_whatever_the_shape() {
    for size in [1.0, 1e-15, 1e14] {
        for (tier, [most, former]) in [
            (Accuracy::Robust, worst::<f32>(Accuracy::Robust, size)),
            (
                Accuracy::Extended,
                worst::<TwoFloat>(Accuracy::Extended, size),
            ),
            (Accuracy::Double, worst::<f64>(Accuracy::Double, size)),
        ] {
            println!("{tier:?}, size {size:e}: {most} u B, by edge functions {former}");
            assert!(most < ON_PLANE, "{tier:?} {size}: {most}");
            assert!(former > 1000.0, "{tier:?} {size}: {former}");
        }
    }
}

/// The ray along the last axis, and corners of small whole numbers: on edges, at corners, in
/// line with it.
fn whole(n: &mut Numbers) -> Seen<f32> {
    let mut three = || {
        let [x, y, z] = [0; 3].map(|_| n.pick(7) as f32 - 3.0);
        vec3(x, y, z)
    };
    let (x, y) = (three(), three());
    Seen {
        x,
        y,
        along: vec3(1.0, 2.0, 5.0),
    }
}

#[test]
fn what_is_met_is_what_was_met() {
    let mut n = Numbers(6);
    let mut met = 0;
    for index in 0..TRIES {
        let seen = if index % 2 == 0 {
            whole(&mut n)
        } else {
            let (corners, ray) = aimed(&mut n, 1.0);
            seen_corners(ray, shear_of(ray), &triangle_of(corners))
        };
        assert_eq!(passes_between(seen), edge_functions(seen).is_some());
        met += u32::from(passes_between(seen));
    }
    assert!(met > TRIES / 10 && met < TRIES * 9 / 10, "{met}");
}

/// How far across the ray the point with these weights is, in parts of what they may be off: 6 u
/// of the extent, and 2 u of the coordinates as their sum may not be 1.
fn off_the_ray(seen: Seen<f32>, weights: Vec3<f32>) -> f64 {
    let weights: [f32; 3] = weights.into();
    let share = |v: Vec3<f32>| {
        let numbers = <[f32; 3]>::from(v).map(f64::from);
        let most = |of: &dyn Fn(f64, f64) -> f64| {
            let pairs = numbers.iter().flat_map(|a| numbers.map(|b| of(*a, b)));
            pairs.fold(0.0, f64::max)
        };
        let place: f64 = (0..3).map(|k| f64::from(weights[k]) * numbers[k]).sum();
        (
            place.abs(),
            most(&|a, b| (a - b).abs()),
            most(&|a, _| a.abs()),
        )
    };
    let ((x, wide, right), (y, high, above)) = (share(seen.x), share(seen.y));
    let allowed = (6.0 * wide.max(high) + 2.0 * right.max(above)) * unit_of(Accuracy::Robust);
    x.max(y) / allowed
}

#[test]
fn the_weights_give_a_point_of_the_ray() {
    let mut n = Numbers(7);
    let (mut most, mut former, mut least) = (0.0, 0.0, 0.0);
    for _ in 0..TRIES {
        let (corners, ray) = aimed(&mut n, 1.0);
        let triangle = triangle_of(corners);
        let seen = seen_corners(ray, shear_of(ray), &triangle);
        let Some([u, v, w]) = edge_functions(seen) else {
            continue;
        };
        let weights = triangle_weights(ray, &triangle);
        most = f64::max(most, off_the_ray(seen, weights));
        least = f32::min(least, weights.x.min(weights.y).min(weights.z));
        let sum = (u + v) + w;
        let by_edges = vec3(u / sum, v / sum, w / sum);
        former = f64::max(former, off_the_ray(seen, by_edges));
    }
    println!("{most} of what is allowed, by edge functions {former}; weights from {least}");
    assert!(most < 1.0 && former > 1000.0, "{most} {former}");
    // A rounding of 1 - (x + y).
    assert!(least >= -f32::EPSILON, "{least}");
}

/// On edges and at corners too, whatever the order of the corners.
#[test]
fn any_order_of_the_corners_gives_the_same_depth() {
    let mut n = Numbers(8);
    let (mut on_edges, mut at_corners) = (0, 0);
    for _ in 0..TRIES {
        let seen = whole(&mut n);
        let Some(edges) = edge_functions(seen) else {
            continue;
        };
        on_edges += u32::from(edges.contains(&0.0));
        let depth = depth_between(seen);
        for (x, y, along) in [
            (seen.x.x, seen.y.x, seen.along.x),
            (seen.x.y, seen.y.y, seen.along.y),
            (seen.x.z, seen.y.z, seen.along.z),
        ] {
            if x == 0.0 && y == 0.0 {
                at_corners += 1;
                assert_eq!(depth, along, "{seen:?}");
            }
        }
        let lone = lone_corner(seen.x);
        let lone_last = with_last(seen, lone);
        let weights = weights_between(lone_last);
        assert!(off_the_ray(lone_last, weights) < 1.0, "{seen:?}");
        let reversed = |v: Vec3<f32>| vec3(v.y, v.x, v.z);
        for corner in 0..3 {
            let turned = with_last(seen, corner);
            let Seen { x, y, along } = turned;
            let other = Seen {
                x: reversed(x),
                y: reversed(y),
                along: reversed(along),
            };
            for same in [turned, other].map(depth_between) {
                assert_eq!(same.to_bits(), depth.to_bits(), "{seen:?}");
            }
        }
    }
    assert!(
        on_edges > 1000 && at_corners > 1000,
        "{on_edges} {at_corners}"
    );
}

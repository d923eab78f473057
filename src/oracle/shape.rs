//! Whether a ray meets a shape: signs of polynomials, computed in any [`Number`].

use std::cmp::Ordering;

use super::distance::Distance;
use super::number::{Number, Vector, cross, difference, dot, vector};
use crate::kernel::camera::Ray;
use crate::layout::{Disk, Plane, Sphere};

/// A primitive with its numbers.
#[derive(Debug, Clone, Copy)]
pub enum Shape<'a> {
    /// A sphere.
    Sphere(&'a Sphere<f64>),
    /// A plane.
    Plane(&'a Plane<f64>),
    /// A disk.
    Disk(&'a Disk<f64>),
    /// A triangle's corners.
    Triangle([[f64; 3]; 3]),
}

/// What is known of a ray and a shape.
#[derive(Debug, Clone)]
pub enum Outcome<N> {
    /// The number is not good enough to tell.
    Doubt,
    /// It is missed, for certain.
    Miss,
    /// It is hit, for certain.
    Hit(Distance<N>),
}

impl Shape<'_> {
    /// Whether the ray, whose direction is not zero, meets the shape.
    #[inline]
    pub fn decide<N: Number>(&self, ray: Ray<f64>) -> Outcome<N> {
        match self {
            Self::Sphere(sphere) => decide_sphere(ray, sphere),
            Self::Plane(plane) => decide_plane(ray, plane.point, plane.normal),
            Self::Disk(disk) => decide_disk(ray, disk),
            Self::Triangle(corners) => decide_triangle(ray, corners),
        }
    }
}

/// The roots of a t^2 - 2 b t + c, with f from the centre to the origin: a = d.d, b =
/// -f.d, c = f.f - r^2. The discriminant b^2 - a c is a r^2 - |f x d|^2, by Lagrange's
/// identity; in that form nothing of the size of f.f cancels.
#[inline]
fn decide_sphere<N: Number>(ray: Ray<f64>, sphere: &Sphere<f64>) -> Outcome<N> {
    let d: Vector<N> = vector(ray.direction.into());
    let f = difference(&vector(ray.origin.into()), &vector(sphere.center));
    let radius = N::exact(sphere.radius);
    let squared = radius.times(&radius);
    let a = dot(&d, &d);
    let across = cross(&f, &d);
    let discriminant = a.times(&squared).minus(&dot(&across, &across));
    if discriminant.sign() == Some(Ordering::Less) {
        return Outcome::Miss;
    }
    let b = N::exact(0.0).minus(&dot(&f, &d));
    let c = dot(&f, &f).minus(&squared);
    let is_far = match (c.sign(), b.sign()) {
        // Outside or on it, and going away: no root is positive.
        (Some(Ordering::Greater | Ordering::Equal), Some(Ordering::Less | Ordering::Equal)) => {
            return Outcome::Miss;
        }
        (Some(Ordering::Less), _) | (Some(Ordering::Equal), Some(Ordering::Greater)) => true,
        (Some(Ordering::Greater), Some(Ordering::Greater)) => false,
        (None, _) | (_, None) => return Outcome::Doubt,
    };
    if discriminant.sign().is_none() {
        return Outcome::Doubt;
    }
    Outcome::Hit(Distance::Root {
        a,
        b,
        c,
        discriminant,
        is_far,
    })
}

/// A quotient, if it is positive.
#[inline]
fn ahead<N: Number>(over: N, under: N) -> Outcome<N> {
    match (over.sign(), under.sign()) {
        (Some(Ordering::Equal), _) | (_, Some(Ordering::Equal)) => Outcome::Miss,
        (Some(over_sign), Some(under_sign)) if over_sign != under_sign => Outcome::Miss,
        (Some(_), Some(_)) => Outcome::Hit(Distance::Quotient { over, under }),
        _ => Outcome::Doubt,
    }
}

/// t = (p - o).n / d.n.
#[inline]
fn decide_plane<N: Number>(ray: Ray<f64>, point: [f64; 3], normal: [f64; 3]) -> Outcome<N> {
    let n: Vector<N> = vector(normal);
    let to_point = difference(&vector(point), &vector(ray.origin.into()));
    ahead(dot(&to_point, &n), dot(&vector(ray.direction.into()), &n))
}

/// The plane's point is f + t d from the centre; times d.n that is f (d.n) - d (f.n) = n x
/// (f x d), so its square is compared with r^2 (d.n)^2.
#[inline]
fn decide_disk<N: Number>(ray: Ray<f64>, disk: &Disk<f64>) -> Outcome<N> {
    let of_plane = decide_plane(ray, disk.center, disk.normal);
    if matches!(of_plane, Outcome::Miss) {
        return of_plane;
    }
    let d: Vector<N> = vector(ray.direction.into());
    let n: Vector<N> = vector(disk.normal);
    let f = difference(&vector(ray.origin.into()), &vector(disk.center));
    let from_center = cross(&n, &cross(&f, &d));
    let rim = N::exact(disk.radius).times(&dot(&d, &n));
    let outside = dot(&from_center, &from_center).minus(&rim.times(&rim));
    match outside.sign() {
        Some(Ordering::Greater) => Outcome::Miss,
        Some(_) => of_plane,
        None => Outcome::Doubt,
    }
}

/// The axis along which a vector is largest.
pub fn largest_axis(v: [f64; 3]) -> usize {
    let size = v.map(f64::abs);
    let xy = usize::from(size[1] > size[0]);
    if size[2] > size[xy] { 2 } else { xy }
}

/// v with its components turned so that `axis` comes last.
#[inline]
fn axis_last<N: Clone>(v: &Vector<N>, axis: usize) -> Vector<N> {
    std::array::from_fn(|place| v[(axis + 1 + place) % 3].clone())
}

/// A point from the ray's origin on as the ray sees it: two components of p x d.
#[inline]
fn seen<N: Number>(p: &Vector<N>, d: &Vector<N>) -> [N; 2] {
    [
        p[1].times(&d[2]).minus(&p[2].times(&d[1])),
        p[2].times(&d[0]).minus(&p[0].times(&d[2])),
    ]
}

/// On which side of the line from one to the other the ray is.
#[inline]
fn side_of<N: Number>(from: &[N; 2], to: &[N; 2]) -> N {
    from[0].times(&to[1]).minus(&from[1].times(&to[0]))
}

/// With corners A, B, C from the origin on, (C x d) x (B x d) = [C, B, d] d, so one
/// component of it tells the sign of the triple product. It is taken from the corners'
/// distances from the ray, which are small where the corners are far. The ray meets the
/// triangle where no two of the three products differ in sign; t = N.A / N.d.
#[inline]
fn decide_triangle<N: Number>(ray: Ray<f64>, corners: &[[f64; 3]; 3]) -> Outcome<N> {
    let axis = largest_axis(ray.direction.into());
    let d: Vector<N> = axis_last(&vector(ray.direction.into()), axis);
    let o: Vector<N> = axis_last(&vector(ray.origin.into()), axis);
    let corners: [Vector<N>; 3] = corners.map(|corner| axis_last(&vector(corner), axis));
    let from_origin: [Vector<N>; 3] = std::array::from_fn(|i| difference(&corners[i], &o));
    let [a, b, c]: [[N; 2]; 3] = std::array::from_fn(|i| seen(&from_origin[i], &d));
    let signs = [side_of(&c, &b), side_of(&a, &c), side_of(&b, &a)].map(|side| side.sign());
    let any = |sign| signs.contains(&Some(sign));
    if any(Ordering::Greater) && any(Ordering::Less) {
        return Outcome::Miss;
    }
    let normal = cross(
        &difference(&corners[1], &corners[0]),
        &difference(&corners[2], &corners[0]),
    );
    let outcome = ahead(dot(&normal, &from_origin[0]), dot(&normal, &d));
    if matches!(outcome, Outcome::Hit(_)) && signs.contains(&None) {
        return Outcome::Doubt;
    }
    outcome
}

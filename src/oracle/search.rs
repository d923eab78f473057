//! The nearest of the primitives that a ray meets: what may still be it, in intervals of t,
//! then which one it is.

use std::cmp::Ordering;

use super::distance::{Distance, compare};
use super::double::Double;
use super::exact::Exact;
use super::filter::Bounded;
use super::margin::Nearness;
use super::number::Number;
use super::shape::{Outcome, Shape};
use super::{Oracle, ShapeKind};
use crate::kernel::camera::Ray;
use crate::kernel::vector::vector_length;

/// t + `t_rest` is off by at most this part of t.
const PRECISION: f64 = 1.0 / (1_u128 << 80) as f64;

/// A primitive of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Its id.
    pub id: u32,
    /// Its row in its kind's table.
    pub row: u32,
    /// Its kind.
    pub kind: ShapeKind,
}

/// A hit, with the ends of an interval that holds its t.
#[derive(Debug, Clone, Copy)]
pub struct Hit {
    /// What is hit.
    pub place: Place,
    low: f64,
    high: f64,
}

impl Hit {
    /// The hit of a primitive, if there is one.
    #[inline]
    pub fn of(place: Place, shape: &Shape<'_>, ray: Ray<f64>) -> Option<Self> {
        let [low, high] = settle(shape, ray)?;
        Some(Self { place, low, high })
    }
}

/// The search for the nearest hit of one ray.
pub struct Search<'a> {
    oracle: &'a Oracle<'a>,
    ray: Ray<f64>,
    hits: Vec<Hit>,
    /// Every primitive that was tested, and its id.
    tested: Vec<(u32, Nearness)>,
    limit: f64,
}

impl<'a> Search<'a> {
    /// Nothing tested yet.
    pub fn new(oracle: &'a Oracle<'a>, ray: Ray<f64>) -> Self {
        Self {
            oracle,
            ray,
            hits: Vec::with_capacity(8),
            tested: Vec::with_capacity(32),
            limit: f64::INFINITY,
        }
    }

    /// The nearest hit is not beyond this t.
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// Tests a primitive.
    pub fn test(&mut self, kind: ShapeKind, row: u32) {
        let (id, shape) = self.oracle.shape(kind, row);
        self.tested.push((id, shape.nearness(self.ray)));
        if let Some(hit) = Hit::of(Place { id, row, kind }, &shape, self.ray)
            && hit.low <= self.limit
        {
            self.hits.push(hit);
            self.limit = self.limit.min(hit.high);
        }
    }

    /// The nearest of all hits; of those at one t, the one with the lowest id.
    pub fn nearest(&self) -> Option<Place> {
        let near = self.hits.iter().filter(|hit| hit.low <= self.limit);
        let nearest = near.min_by(|first, second| order(self.oracle, self.ray, first, second));
        nearest.map(|hit| hit.place)
    }

    /// See [`super::Truth::margin`].
    pub fn margin(&self, nearest: Option<(Place, f64)>) -> f64 {
        let length = vector_length(self.ray.direction);
        let margins = self.tested.iter().map(|(id, near)| match nearest {
            None => near.slack.abs(),
            Some((place, _)) if place.id == *id => near.slack.abs(),
            Some((_, t)) => near.to_become_nearest(t, length),
        });
        margins.fold(f64::INFINITY, f64::min)
    }
}

/// By t, then by id. Intervals that do not overlap tell, if need be with more bits; else t
/// is compared exactly.
pub fn order(oracle: &Oracle<'_>, ray: Ray<f64>, first: &Hit, second: &Hit) -> Ordering {
    if first.high < second.low {
        return Ordering::Less;
    }
    if second.high < first.low {
        return Ordering::Greater;
    }
    let [x, y] = [first, second].map(|hit| oracle.shape(hit.place.kind, hit.place.row).1);
    if let Outcome::Hit(to_x) = x.decide::<Double>(ray)
        && let Outcome::Hit(to_y) = y.decide::<Double>(ray)
        && let Some(order) = to_x.value().minus(&to_y.value()).sign()
        && order != Ordering::Equal
    {
        return order;
    }
    let order = compare(&exact_distance(&x, ray), &exact_distance(&y, ray));
    order.then(first.place.id.cmp(&second.place.id))
}

/// The ends of an interval that holds t, if the ray meets the shape.
fn settle(shape: &Shape<'_>, ray: Ray<f64>) -> Option<[f64; 2]> {
    match shape.decide::<Bounded>(ray) {
        Outcome::Miss => None,
        Outcome::Hit(distance) => Some(distance.value().ends()),
        Outcome::Doubt => settle_doubt(shape, ray),
    }
}

/// What is in doubt is decided with more bits, then exactly.
#[cold]
fn settle_doubt(shape: &Shape<'_>, ray: Ray<f64>) -> Option<[f64; 2]> {
    let is_hit = match shape.decide::<Double>(ray) {
        Outcome::Miss => false,
        Outcome::Hit(_) => true,
        Outcome::Doubt => matches!(shape.decide::<Exact>(ray), Outcome::Hit(_)),
    };
    is_hit.then(|| {
        let [t, _] = precise_t(shape, ray);
        [t.next_down(), t.next_up()]
    })
}

fn exact_distance(shape: &Shape<'_>, ray: Ray<f64>) -> Distance<Exact> {
    match shape.decide(ray) {
        Outcome::Hit(distance) => distance,
        Outcome::Miss | Outcome::Doubt => unreachable!("what is certain is so exactly"),
    }
}

/// The nearest f64 of the t of a shape that is hit, and of what t then lacks.
pub fn precise_t(shape: &Shape<'_>, ray: Ray<f64>) -> [f64; 2] {
    if let Outcome::Hit(distance) = shape.decide::<Double>(ray) {
        let t = distance.value();
        // Whatever the rest is, within its error, it must round to the same f64.
        let rounds_to = |rest: f64| t.high + rest == t.high;
        let is_sure = rounds_to(t.low - 2.0 * t.error) && rounds_to(t.low + 2.0 * t.error);
        if t.error <= t.high * PRECISION && is_sure {
            // -0 becomes 0.
            return [t.high, t.low + 0.0];
        }
    }
    exact_t(shape, ray)
}

/// As [`precise_t`], by integers alone.
pub fn exact_t(shape: &Shape<'_>, ray: Ray<f64>) -> [f64; 2] {
    exact_distance(shape, ray).value().to_f64()
}

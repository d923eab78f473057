//! The oracle: what a ray hits first, and at which t, exactly.
//!
//! The numbers of a scene and of a ray are taken as exact, and the answer is that of
//! mathematics: a hit has t > 0; a ray that touches a sphere hits it; a disk's rim, a
//! triangle's edges and its corners belong to it, from both sides; a ray in the plane of a
//! plane, a disk or a triangle misses it, and so does every ray a triangle without area. Of
//! two hits at one t the lower id counts. The shapes' own boxes have no part in it.
//!
//! It is what the accuracy of the tracers is measured by, so it shares none of their
//! arithmetic. [`shape`] has the formulas, once, over a [`number`]; [`filter`], [`double`]
//! and [`exact`] are the widths; [`mod@distance`] compares hits; [`search`] takes the
//! cheapest width that decides; [`mod@walk`] goes through the tree, if there is one;
//! [`margin`] tells how near a decision is to turning.

pub mod distance;
pub mod double;
pub mod exact;
pub mod filter;
pub mod margin;
pub mod number;
pub mod search;
pub mod shape;
pub mod walk;

#[cfg(test)]
mod tests;

use serde::Serialize;

use self::exact::scale;
use self::search::{Hit, Place, Search, order, precise_t};
use self::shape::Shape;
use self::walk::walk;
use crate::flat::{Flat, Kind};
use crate::kernel::camera::Ray;
use crate::kernel::vector::Vec3;
use crate::layout::NO_HIT;

/// The kinds of primitives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ShapeKind {
    /// A sphere.
    Sphere,
    /// A plane.
    Plane,
    /// A disk.
    Disk,
    /// A triangle.
    Triangle,
}

impl From<Kind> for ShapeKind {
    fn from(kind: Kind) -> Self {
        match kind {
            Kind::Sphere => Self::Sphere,
            Kind::Disk => Self::Disk,
            Kind::Triangle => Self::Triangle,
        }
    }
}

/// What a ray hits first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Truth {
    /// The primitive, or [`NO_HIT`].
    pub id: u32,
    /// Its row in its kind's table.
    pub row: u32,
    /// The f64 nearest to the exact t; infinity where nothing is hit.
    pub t: f64,
    /// What the exact t is more than `t`. The sum of both is off by at most 2^-80 of t.
    pub t_rest: f64,
    /// The smallest relative change, roughly, that would turn the decision: hit or miss,
    /// or which primitive. Lengths are in parts of |o| + t |d| + |c| + r of the shape
    /// concerned. The hit has to stay one, a near miss to become one, and a shape behind to
    /// come to the front; so it is small at the edge between two triangles. Of a miss,
    /// everything tested counts. Infinity where nothing was tested.
    ///
    /// What a tree leaves out is not counted. Its boxes are so padded that this cannot
    /// matter to margins below 2^-21.
    pub margin: f64,
}

/// A primitive that a ray meets.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Candidate {
    /// The primitive.
    pub id: u32,
    /// Its row in its kind's table.
    pub row: u32,
    /// Its kind.
    pub kind: ShapeKind,
    /// See [`Truth::t`].
    pub t: f64,
    /// See [`Truth::t_rest`].
    pub t_rest: f64,
}

/// Answers for one scene.
///
/// # Examples
///
/// ```
/// use rayproof::Scene;
/// use rayproof::flatten::flatten;
/// use rayproof::kernel::camera::camera_ray;
/// use rayproof::oracle::Oracle;
///
/// let scene = Scene::load("assets/scenes/shapes.toml")?.with_size(64, 64);
/// let flat = flatten::<f64>(&scene);
/// let ray = camera_ray(&flat.camera, flat.size, 32, 32);
/// let oracle = Oracle::new(&flat);
/// assert_eq!(oracle.closest(ray).id, oracle.candidates(ray)[0].id);
/// # Ok::<(), rayproof::Error>(())
/// ```
#[derive(Debug)]
pub struct Oracle<'a> {
    flat: &'a Flat<f64>,
}

/// The ray with its direction times a power of two, so that its largest component is from 1
/// to 2, and the exponent: products then neither overflow nor vanish, and t is to be
/// multiplied by that power. None if the direction is zero.
fn tame(ray: Ray<f64>) -> Option<(Ray<f64>, isize)> {
    let d: [f64; 3] = ray.direction.into();
    let largest = d[shape::largest_axis(d)].abs();
    if largest == 0.0 {
        return None;
    }
    let exponent = (1023 - (largest.to_bits() >> 52) as isize).clamp(-1000, 1000);
    let scaled = d.map(|component| scale(component, exponent));
    // A component that does vanish would no longer be exact.
    if d != scaled.map(|component| scale(component, -exponent)) {
        return Some((ray, 0));
    }
    let direction = Vec3::from(scaled);
    Some((Ray { direction, ..ray }, exponent))
}

impl<'a> Oracle<'a> {
    /// For a scene all of whose numbers are finite. Its tree is used if it has one.
    pub fn new(flat: &'a Flat<f64>) -> Self {
        Self { flat }
    }

    /// What the ray hits first. A ray whose direction is zero hits nothing.
    ///
    /// # Panics
    ///
    /// Where a number that matters is not finite.
    pub fn closest(&self, ray: Ray<f64>) -> Truth {
        let nothing = Truth {
            id: NO_HIT,
            row: 0,
            t: f64::INFINITY,
            t_rest: 0.0,
            margin: f64::INFINITY,
        };
        let Some((ray, exponent)) = tame(ray) else {
            return nothing;
        };
        let mut search = Search::new(self, ray);
        if self.flat.pairs.is_empty() {
            for (kind, row) in self.primitives() {
                search.test(kind, row);
            }
        } else {
            for row in 0..self.flat.planes.len() as u32 {
                search.test(ShapeKind::Plane, row);
            }
            walk(self.flat, ray, search.limit(), |kind, rows| {
                rows.for_each(|row| search.test(kind.into(), row));
                search.limit()
            });
        }
        let Some(place) = search.nearest() else {
            return Truth {
                margin: search.margin(None),
                ..nothing
            };
        };
        let [t, t_rest] = precise_t(&self.shape(place.kind, place.row).1, ray);
        Truth {
            id: place.id,
            row: place.row,
            t: scale(t, exponent),
            t_rest: scale(t_rest, exponent),
            margin: search.margin(Some((place, t))),
        }
    }

    /// All that the ray meets, the nearest first, by way of no tree.
    ///
    /// # Panics
    ///
    /// As [`Oracle::closest`].
    pub fn candidates(&self, ray: Ray<f64>) -> Vec<Candidate> {
        let Some((ray, exponent)) = tame(ray) else {
            return Vec::new();
        };
        let hit = |(kind, row)| {
            let (id, shape) = self.shape(kind, row);
            Hit::of(Place { id, row, kind }, &shape, ray)
        };
        let mut hits: Vec<Hit> = self.primitives().filter_map(hit).collect();
        hits.sort_by(|first, second| order(self, ray, first, second));
        let candidate = |Hit { place, .. }: Hit| {
            let shape = self.shape(place.kind, place.row).1;
            let [t, t_rest] = precise_t(&shape, ray).map(|part| scale(part, exponent));
            Candidate {
                id: place.id,
                row: place.row,
                kind: place.kind,
                t,
                t_rest,
            }
        };
        hits.into_iter().map(candidate).collect()
    }

    /// Kind and row of every primitive.
    fn primitives(&self) -> impl Iterator<Item = (ShapeKind, u32)> {
        let flat = self.flat;
        let rows = |kind, count: usize| (0..count as u32).map(move |row| (kind, row));
        rows(ShapeKind::Sphere, flat.spheres.len())
            .chain(rows(ShapeKind::Plane, flat.planes.len()))
            .chain(rows(ShapeKind::Disk, flat.disks.len()))
            .chain(rows(ShapeKind::Triangle, flat.triangles.len()))
    }

    /// Id and shape of the primitive in a row of its kind's table.
    pub fn shape(&self, kind: ShapeKind, row: u32) -> (u32, Shape<'a>) {
        let flat = self.flat;
        let index = row as usize;
        match kind {
            ShapeKind::Sphere => (flat.sphere_ids[index], Shape::Sphere(&flat.spheres[index])),
            ShapeKind::Plane => (flat.first_plane() + row, Shape::Plane(&flat.planes[index])),
            ShapeKind::Disk => (flat.disk_ids[index], Shape::Disk(&flat.disks[index])),
            ShapeKind::Triangle => {
                let corners = flat.triangles[index];
                let at = |vertex: u32| flat.vertices[vertex as usize];
                (corners.id, Shape::Triangle(corners.vertices.map(at)))
            }
        }
    }
}

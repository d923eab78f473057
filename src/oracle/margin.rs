//! How near a decision is to turning, in f64 and roughly: it tells the rays on which a
//! tracer of few bits cannot be blamed, and decides nothing.

use super::shape::Shape;
use crate::kernel::camera::Ray;
use crate::kernel::vector::{Vec3, cross_product, dot_product, vector_length};
use crate::layout::{Disk, Plane, Sphere};

/// How a ray stands to a shape that it hits or misses.
#[derive(Debug, Clone, Copy)]
pub struct Nearness {
    /// t of the hit, or where there would be one.
    pub t: f64,
    /// What is left of the condition that fails or comes closest to it, in parts of the
    /// scale: negative where the shape is missed.
    pub slack: f64,
    /// |o| + t |d| + |c| + r: what an error of one part in so many is measured by.
    pub scale: f64,
    /// How much the shape has to move for its hit to move by 1 along the ray: the sine of the
    /// angle at which a flat shape is seen, else 1.
    pub slope: f64,
}

impl Nearness {
    /// Of a shape within `size` of the camera, seen at t; both conditions in lengths.
    fn of_finite(ray: Ray<f64>, size: f64, t: f64, inside: f64, ahead: f64) -> Self {
        let most = vector_length(ray.origin) + size;
        // A point of the shape is no farther, whatever a t of 0/0 says.
        let along = (t.abs() * vector_length(ray.direction)).min(most);
        let scale = most + along;
        Self {
            t,
            slack: inside.min(ahead) / scale,
            scale,
            slope: 1.0,
        }
    }

    /// The part of the scale by which a ray whose nearest hit is at `nearest` is from
    /// hitting this shape instead.
    pub fn to_become_nearest(&self, nearest: f64, length: f64) -> f64 {
        let behind = (self.t - nearest) * length * self.slope / self.scale;
        if self.slack < 0.0 {
            behind.max(-self.slack)
        } else {
            behind.max(0.0)
        }
    }
}

/// Positive where both are of one sign; the smaller of the changes that would turn it.
fn alike(a: f64, b: f64) -> f64 {
    a.min(b).max((-a).min(-b))
}

impl Shape<'_> {
    /// How the ray stands to the shape.
    pub fn nearness(&self, ray: Ray<f64>) -> Nearness {
        match self {
            Self::Sphere(sphere) => sphere_nearness(ray, sphere),
            Self::Plane(plane) => plane_nearness(ray, plane),
            Self::Disk(disk) => disk_nearness(ray, disk),
            Self::Triangle(corners) => triangle_nearness(ray, corners.map(Vec3::from)),
        }
    }
}

/// The ray's nearest point against the radius, and the last root against zero.
fn sphere_nearness(ray: Ray<f64>, sphere: &Sphere<f64>) -> Nearness {
    let center = Vec3::from(sphere.center);
    let f = ray.origin - center;
    let length = vector_length(ray.direction);
    let from_center = vector_length(cross_product(f, ray.direction)) / length;
    let inside = sphere.radius - from_center;
    let middle = -dot_product(f, ray.direction) / length;
    let half_chord = (inside.max(0.0) * (sphere.radius + from_center)).sqrt();
    let first = middle - half_chord;
    let last = middle + half_chord;
    let front = if first > 0.0 { first } else { last.max(0.0) };
    let size = vector_length(center) + sphere.radius;
    Nearness::of_finite(ray, size, front / length, inside, last)
}

/// The origin's side of the plane against the direction's. A t below zero turns at zero or,
/// if the direction turns, so far behind as it was ahead.
fn plane_nearness(ray: Ray<f64>, plane: &Plane<f64>) -> Nearness {
    let (point, normal) = (Vec3::from(plane.point), Vec3::from(plane.normal));
    let distance = dot_product(point - ray.origin, normal);
    let slope = dot_product(ray.direction, normal);
    let (length, normal_length) = (vector_length(ray.direction), vector_length(normal));
    let size = vector_length(point) + vector_length(ray.origin);
    let t = (distance / slope).abs();
    Nearness {
        t,
        slack: alike(
            distance / (normal_length * size),
            slope / (length * normal_length),
        ),
        scale: size + t * length,
        slope: 1.0,
    }
}

/// As [`Shape::decide`] has it, over what makes it a length seen along the ray.
fn disk_nearness(ray: Ray<f64>, disk: &Disk<f64>) -> Nearness {
    let (center, normal) = (Vec3::from(disk.center), Vec3::from(disk.normal));
    let f = ray.origin - center;
    let length = vector_length(ray.direction);
    let lengths = length * vector_length(normal);
    let slope = dot_product(ray.direction, normal);
    let from_center = cross_product(normal, cross_product(f, ray.direction));
    let inside = (disk.radius * slope.abs() - vector_length(from_center)) / lengths;
    let t = -dot_product(f, normal) / slope;
    let middle = -dot_product(f, ray.direction) / length;
    let [near, far] = [middle - disk.radius, middle + disk.radius];
    let front = (t.abs() * length).max(near).min(far) / length;
    let size = vector_length(center) + disk.radius;
    Nearness::of_finite(ray, size, front, inside, t * length)
}

/// By how much the ray or a corner would have to move for the ray to be on an edge's line,
/// all of one sign inside. It is the ray's distance from the line or, where a corner is
/// farther away than the edge is long, less: the line turns about the other corner.
fn triangle_nearness(ray: Ray<f64>, corners: [Vec3<f64>; 3]) -> Nearness {
    let d = ray.direction;
    let length = vector_length(d);
    let from_origin = corners.map(|corner| corner - ray.origin);
    let seen = from_origin.map(|corner| cross_product(corner, d));
    let distance = |from: usize, to: usize| {
        let across = dot_product(cross_product(seen[from], seen[to]), d);
        let edge = vector_length(seen[to] - seen[from]);
        let lever = vector_length(seen[from]).max(vector_length(seen[to]));
        if edge == 0.0 {
            return 0.0;
        }
        across / (edge.max(lever) * (length * length))
    };
    let sides = [distance(2, 1), distance(0, 2), distance(1, 0)];
    let least = sides.into_iter().fold(f64::INFINITY, f64::min);
    let most = sides.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let inside = least.max(-most);
    let normal = cross_product(corners[1] - corners[0], corners[2] - corners[0]);
    let t = dot_product(normal, from_origin[0]) / dot_product(normal, d);
    let along = from_origin.map(|corner| dot_product(corner, d) / length);
    let near = along.into_iter().fold(f64::INFINITY, f64::min);
    let far = along.into_iter().fold(f64::NEG_INFINITY, f64::max);
    // Where the ray is almost in the plane, a t beyond the corners tells nothing.
    let front = (t * length).max(near).min(far);
    let size = corners.map(vector_length).into_iter().fold(0.0, f64::max);
    let slope = dot_product(normal, d).abs() / (vector_length(normal) * length);
    Nearness {
        slope: if slope.is_nan() { 0.0 } else { slope },
        ..Nearness::of_finite(ray, size, front / length, inside, front)
    }
}

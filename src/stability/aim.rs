//! Rays that are aimed where a decision is hard. They are rounded to f32 last, and the oracle
//! is asked about the rounded ones.

use glam::DVec3;

use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::random::Numbers;

/// The ray from a point in a direction, rounded.
pub fn ray(from: DVec3, direction: DVec3) -> Ray<f32> {
    let rounded = |v: DVec3| v.as_vec3().to_array().into();
    Ray {
        origin: rounded(from),
        direction: rounded(direction),
    }
}

/// The ray from a point to another, which it reaches at t = 1.
pub fn ray_to(from: DVec3, target: DVec3) -> Ray<f32> {
    ray(from, target - from)
}

/// Any direction square to this one, of length 1.
pub fn across(direction: DVec3, n: &mut Numbers) -> DVec3 {
    direction.cross(n.direction()).normalize()
}

/// A ray from a point that passes a centre at a distance of `impact`, which is less than that
/// of the point; the direction is of any length from 1/2 to 2.
pub fn passing(from: DVec3, center: DVec3, impact: f64, n: &mut Numbers) -> Ray<f32> {
    let to_center = center - from;
    let distance = to_center.length();
    let axis = to_center / distance;
    let sine = impact / distance;
    let cosine = (1.0 - sine * sine).sqrt();
    let direction = axis * cosine + across(axis, n) * sine;
    ray(from, direction * n.between(0.5, 2.0))
}

/// The f32 so many steps above this one, or below.
pub fn step(number: f64, ulps: i32) -> f64 {
    let number = number as f32;
    if number == 0.0 {
        return 0.0;
    }
    let bits = number.to_bits().wrapping_add_signed(ulps);
    f64::from(f32::from_bits(bits))
}

/// The corners of a triangle of the scene, beginning with any.
pub fn any_corners(flat: &Flat<f64>, n: &mut Numbers) -> [DVec3; 3] {
    let vertices = flat.triangles[n.pick(flat.triangles.len())].vertices;
    let first = n.pick(3);
    [0, 1, 2].map(|corner| {
        let vertex = vertices[(first + corner) % 3];
        DVec3::from(flat.vertices[vertex as usize])
    })
}

/// A point of an edge of the scene.
pub fn on_an_edge(flat: &Flat<f64>, n: &mut Numbers) -> DVec3 {
    let [a, b, _] = any_corners(flat, n);
    a.lerp(b, n.between(0.0, 1.0))
}

/// A vertex of the scene.
pub fn a_vertex(flat: &Flat<f64>, n: &mut Numbers) -> DVec3 {
    any_corners(flat, n)[0]
}

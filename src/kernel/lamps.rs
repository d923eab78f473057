//! Lamps that have a size.
//!
//! Shirley, Wang, Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM
//! Transactions on Graphics 15(1), 1996.

use super::circle::{circle_point, disk_point};
use super::dimensions::dimension_of_lamp;
use super::divide::{divide, square_root};
use super::frame::{axes_around, from_axes};
use super::hit::{Hit, Surface};
use super::integrator::{Path, leg_start};
use super::numbers::number_pair;
use super::offset::leave_surface;
use super::real::Real;
use super::sources::{Arriving, found_weight, nothing_arriving};
use super::vector::{Vec3, divided, dot_product, taxicab_length, vector_length};
use crate::flat::Flat;
use crate::layout::{DISK_LAMP, LampRecord, NONE, SPHERE_LAMP};

/// A whole turn, in radians.
pub const WHOLE_TURN: f32 = std::f32::consts::TAU;

/// 1 / pi: what a surface looks like under so much light.
pub const PER_PI: f32 = std::f32::consts::FRAC_1_PI;

/// A lamp that covers less of what a place sees does not light it: the least normal number,
/// so that its inverse is finite.
pub const LEAST_ANGLE: f32 = f32::MIN_POSITIVE;

/// How many lamps there are.
pub fn count_lamps<R>(flat: &Flat<R>) -> u32 {
    flat.lamps.len() as u32
}

/// 1 - cos of the angle by which a spherical lamp reaches from its middle, as seen from
/// this far from there; 0 from within.
///
/// By the square of the sine, so that nothing cancels where the lamp is small.
fn cap_height(lamp: &LampRecord, from_center: Vec3<f32>) -> f32 {
    let square = dot_product(from_center, from_center);
    let own = lamp.radius * lamp.radius;
    if square <= own {
        return 0.0;
    }
    let sine_square = divide(own, square);
    divide(sine_square, 1.0 + square_root(1.0 - sine_square))
}

/// The solid angle that stands for a point drawn on a lamp, seen `towards` there from a place:
/// what its density is the inverse of. 0 where the lamp does not light the place.
fn angle_of_lamp(lamp: &LampRecord, place: Vec3<f32>, towards: Vec3<f32>) -> f32 {
    if lamp.form == SPHERE_LAMP {
        return WHOLE_TURN * cap_height(lamp, place - Vec3::from(lamp.center));
    }
    let square = dot_product(towards, towards);
    let along = -dot_product(Vec3::from(lamp.normal), towards);
    if square == 0.0 || along <= 0.0 {
        return 0.0;
    }
    divide(lamp.area, square) * divide(along, square_root(square))
}

/// The inverse of such an angle; 0 where there is none.
fn density_of_angle(angle: f32) -> f32 {
    if angle < LEAST_ANGLE {
        return 0.0;
    }
    divide(1.0, angle)
}

/// The outward normal of a point drawn on a sphere, evenly by the angle under which a place
/// sees it that is outside of the sphere.
///
/// In units of the sines and cosines of the angle at the place (to the lamp's edge:
/// `largest`) and at the middle, by the law of sines: nothing cancels but near the surface.
fn drawn_normal(lamp: &LampRecord, from_center: Vec3<f32>, pair: [f32; 2]) -> Vec3<f32> {
    let distance = vector_length(from_center);
    let largest = divide(lamp.radius, distance);
    let cap = cap_height(lamp, from_center);
    let lowered = pair[0] * cap;
    let cosine = 1.0 - lowered;
    // The square of the sine, over that of the largest.
    let part = pair[0] * divide(2.0 - lowered, 2.0 - cap);
    let rest = 1.0 - part;
    // By roundings it may be below 0.
    let chord = square_root(if rest > 0.0 { rest } else { 0.0 });
    let along = part * largest + cosine * chord;
    let across = square_root(part) * (cosine - largest * chord);
    let point = circle_point(pair[1]);
    let axes = axes_around(divided(from_center, distance));
    from_axes(axes, across * point[0], across * point[1], along)
}

/// From the middle of a disk or of a rectangle to a point drawn on it.
fn drawn_point(lamp: &LampRecord, pair: [f32; 2]) -> Vec3<f32> {
    let mut point = [pair[0] * 2.0 - 1.0, pair[1] * 2.0 - 1.0];
    if lamp.form == DISK_LAMP {
        point = disk_point(pair);
    }
    Vec3::from(lamp.right) * point[0] + Vec3::from(lamp.up) * point[1]
}

/// What comes from a point drawn on a lamp.
///
/// The ray that looks for what is in between ends as far before the lamp as it would start
/// if it left there. So it does not meet the lamp: both its ends are on the outer side.
pub fn arriving_from_lamp<R: Real>(
    flat: &Flat<R>,
    lamp: u32,
    path: &Path<R>,
    surface: &Surface,
) -> Arriving {
    let record = &flat.lamps[lamp as usize];
    let center = Vec3::from(record.center);
    let place = surface.position;
    let pair = number_pair(path.numbers, dimension_of_lamp(path.leg, lamp));
    let mut normal = Vec3::from(record.normal);
    let mut point = center;
    if record.form == SPHERE_LAMP {
        normal = drawn_normal(record, place - center, pair);
        point = point + normal * record.radius;
    } else {
        point = point + drawn_point(record, pair);
    }
    let towards = point - place;
    let length = vector_length(towards);
    let angle = angle_of_lamp(record, place, towards);
    let density = density_of_angle(angle);
    if length == 0.0 || density == 0.0 {
        return nothing_arriving();
    }
    let reach = record.reach + taxicab_length(place);
    Arriving {
        towards,
        length,
        color: Vec3::from(record.radiance) * (angle * PER_PI),
        goal: leave_surface::<R>(point, normal, normal, reach),
        limit: 1.0,
        density,
        ..nothing_arriving()
    }
}

/// Whether a ray comes to the side of a lamp that shines.
fn meets_front(lamp: &LampRecord, position: Vec3<f32>, direction: Vec3<f32>) -> bool {
    let mut outward = Vec3::from(lamp.normal);
    if lamp.form == SPHERE_LAMP {
        outward = position - Vec3::from(lamp.center);
    }
    dot_product(outward, direction) < 0.0
}

/// How much of a lamp's light is due to a path that found it; 1 for what is no lamp.
pub fn weight_of_lamp<R: Real>(
    flat: &Flat<R>,
    path: &Path<R>,
    _hit: Hit<R>,
    surface: &Surface,
    material: u32,
) -> f32 {
    let lamp = flat.finishes[material as usize].lamp;
    if lamp == NONE {
        return 1.0;
    }
    let record = &flat.lamps[lamp as usize];
    if !meets_front(record, surface.position, path.ray.direction.to_f32()) {
        return 0.0;
    }
    if path.density == 0.0 {
        return 1.0;
    }
    let place = leg_start(path);
    let angle = angle_of_lamp(record, place, surface.position - place);
    found_weight(flat, path.density, density_of_angle(angle))
}

//! What planes and disks alone are broken by.

use rayproof::flat::Flat;
use rayproof::found::Found;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::vector::{Vec3, dot_product};
use rayproof::layout::{Disk, NO_HIT};

use super::broken_round::{Part, closest, crossing, only, square_from_center};

/// The test of the disks only.
fn disk_by(flat: &Flat<f64>, t_of: impl Fn(&Disk<f64>) -> f64) -> Found {
    closest(flat, |part| match part {
        Part::Disk(disk) => t_of(disk),
        _ => f64::INFINITY,
    })
}

/// f32, and what is not below 0 is a hit: NaN and infinity too.
pub(super) fn parallel_unchecked(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    let Some(plane) = flat.planes.first() else {
        unreachable!("there is a plane");
    };
    let rounded = |v: [f64; 3]| Vec3::from(v.map(|x| x as f32));
    let (point, normal) = (rounded(plane.point), rounded(plane.normal));
    let t = crossing(ray.converted::<f32>(), point, normal);
    let id = if t <= 0.0 { NO_HIT } else { 0 };
    Found::new(f64::from(t), id)
}

/// A hit unless it is beyond the rim, which NaN is not.
pub(super) fn only_beyond_is_rejected(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    let disk = &flat.disks[0];
    let t = crossing(ray, disk.center.into(), disk.normal.into());
    let is_beyond = square_from_center(ray, disk, t) > disk.radius * disk.radius;
    let id = if is_beyond || t <= 0.0 { NO_HIT } else { 0 };
    Found::new(t, id)
}

/// f32, and the plane as n.x = h.
pub(super) fn distance_form(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    let plane = &flat.planes[0];
    let rounded = |v: [f64; 3]| Vec3::from(v.map(|x| x as f32));
    let (point, normal) = (rounded(plane.point), rounded(plane.normal));
    let Ray { origin, direction } = ray.converted::<f32>();
    let height = dot_product(point, normal) - dot_product(origin, normal);
    let t = f64::from(height / dot_product(direction, normal));
    Found::new(t, if t > 0.0 { 0 } else { NO_HIT })
}

/// f32, and (o + t d) - c.
pub(super) fn point_from_camera(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    disk_by(flat, |disk| {
        let ray = ray.converted::<f32>();
        let rounded = |v: [f64; 3]| Vec3::from(v.map(|x| x as f32));
        let center = rounded(disk.center);
        let t = crossing(ray, center, rounded(disk.normal));
        let point = (ray.origin + ray.direction * t) - center;
        let radius = disk.radius as f32;
        only(
            t > 0.0 && dot_product(point, point) <= radius * radius,
            f64::from(t),
        )
    })
}

/// Less than r in place of at most r.
pub(super) fn rim_excluded(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    disk_by(flat, |disk| {
        let t = crossing(ray, disk.center.into(), disk.normal.into());
        let limit = disk.radius * disk.radius;
        only(t > 0.0 && square_from_center(ray, disk, t) < limit, t)
    })
}

/// A little more than r.
pub(super) fn rim_with_tolerance(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    disk_by(flat, |disk| {
        let t = crossing(ray, disk.center.into(), disk.normal.into());
        let limit = disk.radius * disk.radius + 1e-3;
        only(t > 0.0 && square_from_center(ray, disk, t) <= limit, t)
    })
}

/// f32, and the rim's test times (d.n)^2.
pub(super) fn without_division(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    disk_by(flat, |disk| {
        let ray = ray.converted::<f32>();
        let rounded = |v: [f64; 3]| Vec3::from(v.map(|x| x as f32));
        let (center, normal) = (rounded(disk.center), rounded(disk.normal));
        let f = ray.origin - center;
        let slope = dot_product(ray.direction, normal);
        let point = f * slope - ray.direction * dot_product(f, normal);
        let rim = disk.radius as f32 * slope;
        let t = crossing(ray, center, normal);
        only(
            t > 0.0 && dot_product(point, point) <= rim * rim,
            f64::from(t),
        )
    })
}

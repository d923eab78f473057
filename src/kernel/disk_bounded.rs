//! Where a ray meets a disk, and how far that may be off. The bounds are derived in
//! `docs/numerics.md`.

use super::doubt::{ERROR, certain_meeting, doubtful_meeting, meeting_in_box};
use super::hit::Meeting;
use super::own_box::ball_box;
use super::plane_bounded::bound_crossing;
use super::probe::Probe;
use super::real::{Real, constant};
use super::vector::{Vec3, dot_product, taxicab_length};
use crate::layout::Disk;

/// Where the ray meets the disk, within bounds, wherever that is.
#[inline]
fn bound_disk<R: Real>(probe: Probe<R>, disk: &Disk<R>) -> Meeting<R> {
    let ray = probe.ray;
    let center = Vec3::from(disk.center);
    let crossing = bound_crossing(ray, center, Vec3::from(disk.normal));
    if crossing.high >= R::MISS {
        return crossing;
    }
    let from_center = (ray.origin - center) + ray.direction * crossing.t;
    let reach = (taxicab_length(center) + taxicab_length(ray.origin)) + disk.radius;
    let along = taxicab_length(ray.direction) * (crossing.high - crossing.low);
    let error = along + reach * constant(ERROR);
    let slack = (R::TWO * disk.radius + error) * error;
    let room = disk.radius * disk.radius - dot_product(from_center, from_center);
    if room < -slack {
        return certain_meeting(R::MISS);
    }
    if room <= slack {
        return doubtful_meeting(crossing.low);
    }
    crossing
}

/// Where the ray meets the disk within the disk's own box, within bounds.
#[inline]
pub fn meet_disk<R: Real>(probe: Probe<R>, disk: &Disk<R>) -> Meeting<R> {
    let meeting = bound_disk(probe, disk);
    if meeting.low >= R::MISS {
        return meeting;
    }
    let center = Vec3::from(disk.center).to_f32();
    let own = ball_box::<R>(center, disk.radius.to_f32());
    meeting_in_box(probe.slabs, own, meeting)
}

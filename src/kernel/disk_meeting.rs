//! Where a ray meets a disk, within the disk's own box.

use super::disk::intersect_disk;
use super::doubt::certain_meeting;
use super::hit::Meeting;
use super::own_box::{ball_box, clamp_to_box};
use super::probe::Probe;
use super::real::Real;
use super::vector::Vec3;
use crate::layout::Disk;

/// Where the ray meets the disk.
#[inline]
pub fn meet_disk<R: Real>(probe: Probe<R>, disk: &Disk<R>) -> Meeting<R> {
    let t = intersect_disk(probe.ray, disk);
    if t < R::MISS {
        let center = Vec3::from(disk.center).to_f32();
        let own = ball_box::<R>(center, disk.radius.to_f32());
        return certain_meeting(clamp_to_box(probe.slabs, own, t));
    }
    certain_meeting(R::MISS)
}

//! Disks, where they are at a time.

use super::motion::moved;
use super::real::Real;
use crate::flat::Flat;
use crate::layout::Disk;

/// The disk in a row of the table.
#[inline]
pub fn disk_at<R: Real>(flat: &Flat<R>, row: u32, time: f32) -> Disk<R> {
    let mut disk = flat.disks[row as usize];
    if flat.has_moving_shapes() {
        let id = flat.disk_ids[row as usize];
        disk.center = moved(flat, disk.center.into(), id, time).into();
    }
    disk
}

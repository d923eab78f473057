//! Bounding boxes in a list.

use super::aabb::clip_to_box;
use super::probe::Probe;
use super::real::Real;
use super::vector::Vec3;
use crate::flat::Flat;

/// Whether the ray meets the box in a row of the table.
pub fn meets_bounding_box<R: Real>(flat: &Flat<R>, probe: Probe<R>, row: u32) -> bool {
    let bounds = &flat.boxes[row as usize];
    let interval = clip_to_box(probe.slabs, Vec3::from(bounds.low), Vec3::from(bounds.high));
    interval.enter <= interval.exit
}

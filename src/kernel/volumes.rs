//! A list of bounding volumes, each before what it holds: a ray that misses one skips
//! all of that.

use super::aabb::clip_to_box;
use super::ball::meets_ball;
use super::count::count_bound;
use super::hit::Hit;
use super::planes::closest_plane;
use super::probe::Probe;
use super::real::Real;
use super::trace::test_row;
use super::vector::Vec3;
use crate::flat::Flat;
use crate::layout::{BALL, Volume};

/// Whether the ray meets the volume, however far away.
fn meets_volume<R: Real>(flat: &Flat<R>, probe: Probe<R>, volume: &Volume) -> bool {
    if volume.kind == BALL {
        return meets_ball(probe.ray, &flat.balls[volume.begin as usize]);
    }
    let bounds = &flat.boxes[volume.begin as usize];
    let interval = clip_to_box(probe.slabs, Vec3::from(bounds.low), Vec3::from(bounds.high));
    interval.enter <= interval.exit
}

/// The nearest of all primitives: of the planes, which no volume holds, then of
/// those in the list.
pub fn closest_in_volumes<R: Real>(flat: &Flat<R>, probe: Probe<R>, hit: &mut Hit<R>) {
    closest_plane(flat, probe, hit);
    let mut entry = 0;
    let mut done = 0;
    while let Some(volume) = flat.volumes.get(entry as usize) {
        if volume.kind >= BALL {
            let met = meets_volume(flat, probe, volume);
            count_bound(hit, met);
            entry = if met { entry + 1 } else { volume.skip };
        } else {
            test_row(flat, probe, volume.kind, volume.begin + done, hit);
            done += 1;
            if volume.begin + done == volume.end {
                entry = volume.skip;
                done = 0;
            }
        }
    }
}

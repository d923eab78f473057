//! A list of bounding volumes, each before what it holds: a ray that misses one skips
//! all of that.

use super::balls::meets_bounding_ball;
use super::boxes::meets_bounding_box;
use super::count::count_bound;
use super::hit::Hit;
use super::planes::closest_plane;
use super::probe::Probe;
use super::real::Real;
use super::screen::is_on_tile;
use super::trace::test_rows;
use crate::flat::Flat;
use crate::layout::{BOX, EVERYTHING, LEAF_KIND};

/// Whether the ray meets the volume, however far away.
fn meets_volume<R: Real>(flat: &Flat<R>, probe: Probe<R>, bound: u32) -> bool {
    if bound & BOX == 0 {
        return meets_bounding_ball(flat, probe, bound);
    }
    meets_bounding_box(flat, probe, bound ^ BOX)
}

/// The nearest of all primitives: of the planes, which no volume holds, then of
/// those in the list.
pub fn closest_in_volumes<R: Real>(flat: &Flat<R>, probe: Probe<R>, hit: &mut Hit<R>) {
    closest_plane(flat, probe, hit);
    let mut entry = 0;
    while let Some(volume) = flat.volumes.get(entry as usize) {
        let mut met = is_on_tile(flat, hit.tile, entry);
        if met && volume.bound != EVERYTHING {
            met = meets_volume(flat, probe, volume.bound);
            count_bound(hit, met);
        }
        if met {
            let first = volume.first & ((1 << LEAF_KIND) - 1);
            let rows = first..first + volume.count;
            test_rows(flat, probe, volume.first >> LEAF_KIND, rows, hit);
        }
        entry = if met { entry + 1 } else { volume.skip };
    }
}

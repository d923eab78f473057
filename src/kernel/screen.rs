//! The screen as a quad-tree: which volumes the rays of a tile may meet. A tile asks only
//! for those that its parent's rays may meet. The smallest tiles are 8 pixels wide.

use super::camera::camera_ray;
use super::cone::{Cone, cone_around, cone_meets_ball};
use super::hit::NO_TILE;
use super::real::Real;
use crate::flat::Flat;
use crate::layout::EVERYTHING;

/// Entries of a word.
pub const WORD: u32 = 32;

/// The smallest tile that a pixel lies in.
pub fn tile_of(size: [u32; 2], x: u32, y: u32) -> u32 {
    (y >> 3) * ((size[0] + 7) >> 3) + (x >> 3)
}

/// Whether rays of the tile may meet an entry of the list.
pub fn is_on_tile<R: Real>(flat: &Flat<R>, tile: u32, entry: u32) -> bool {
    let word = entry / WORD;
    if tile == NO_TILE || word >= flat.tile_words {
        return true;
    }
    let bits = flat.tile_masks()[(tile * flat.tile_words + word) as usize];
    (bits >> (entry % WORD)) & 1 == 1
}

/// The cone around the pixels of a tile whose first one is (x, y).
pub fn cone_of_tile<R: Real>(flat: &Flat<R>, x: u32, y: u32, side: u32) -> Cone<R> {
    let right = (x + side).min(flat.size[0]) - 1;
    let bottom = (y + side).min(flat.size[1]) - 1;
    let direction = |x, y| camera_ray(&flat.camera, flat.size, x, y).direction;
    cone_around(
        direction(x, y),
        direction(right, y),
        direction(x, bottom),
        direction(right, bottom),
    )
}

/// Of the candidates of a word, those that the cone's rays may meet.
pub fn met_by_cone<R: Real>(flat: &Flat<R>, cone: &Cone<R>, word: u32, candidates: u32) -> u32 {
    let mut met = 0;
    for bit in 0..WORD {
        if (candidates >> bit) & 1 == 1 {
            let bound = flat.volumes[(WORD * word + bit) as usize].bound;
            if bound == EVERYTHING || cone_meets_ball(cone, &flat.balls[bound as usize]) {
                met |= 1 << bit;
            }
        }
    }
    met
}

/// The candidates of the largest tile: all entries.
pub fn all_of_word(word: u32, entries: u32) -> u32 {
    let here = (entries - WORD * word).min(WORD);
    u32::MAX >> (WORD - here)
}

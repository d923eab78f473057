//! The screen as a quad-tree, from the whole of it down to tiles of 8 pixels.

use crate::flat::Flat;
use crate::kernel::real::Real;
use crate::kernel::screen::{WORD, all_of_word, cone_of_tile, met_by_cone};
use crate::layout::ScreenLevel;

/// Pixels of the smallest tile's side, as `tile_of` has it.
const SIDE: u32 = 8;

/// Words of all masks at most: 128 MiB, what every device binds. The largest picture, of
/// 32768 x 32768, has 22 million tiles.
const MOST_WORDS: u32 = 1 << 25;

/// Words of a row of tiles at most: 64 to a workgroup, of which a dispatch has so many
/// side by side.
const MOST_ACROSS: u32 = 64 * 65_535;

/// How many words a tile's mask takes for a number of volumes. Volumes past what there
/// is room for are left to the rays.
pub(super) fn words_of_tile(size: [u32; 2], volumes: u32) -> u32 {
    let levels = levels(size, 1);
    let tiles: u32 = levels.iter().map(|level| level.tiles()).sum();
    let room = (MOST_WORDS / tiles).min(MOST_ACROSS / levels[0].split.across);
    volumes.div_ceil(WORD).min(room)
}

/// The masks of the smallest tiles, found on the CPU.
pub fn tile_masks<R: Real>(flat: &Flat<R>) -> Vec<u32> {
    let mut above: Vec<u32> = Vec::new();
    for level in levels(flat.size, flat.tile_words).iter().rev() {
        above = masks(flat, level, &above);
    }
    above
}

/// A level of the tree.
#[derive(Debug, Clone, Copy)]
pub struct Level {
    /// For the shader; masks begin at words, not at tiles.
    pub split: ScreenLevel,
    /// Rows of tiles.
    pub down: u32,
}

impl Level {
    fn tiles(&self) -> u32 {
        self.split.across * self.down
    }
}

/// The levels of a picture's tree, whose masks have so many words, from the smallest tiles
/// up to one that holds the picture.
pub fn levels(size: [u32; 2], words: u32) -> Vec<Level> {
    let mut levels: Vec<Level> = Vec::new();
    let mut side = SIDE;
    let mut first = 0;
    loop {
        let [across, down] = size.map(|pixels| pixels.div_ceil(side));
        if let Some(below) = levels.last_mut() {
            below.split.parent_across = across;
            below.split.parent_first = first;
        }
        let is_root = across == 1 && down == 1;
        levels.push(Level {
            split: ScreenLevel {
                side,
                across,
                first,
                is_root: u32::from(is_root),
                parent_across: 0,
                parent_first: 0,
                padding: [0; 2],
            },
            down,
        });
        if is_root {
            return levels;
        }
        first += across * down * words;
        side *= 2;
    }
}

/// The masks of a level's tiles, from those of the level above.
fn masks<R: Real>(flat: &Flat<R>, level: &Level, above: &[u32]) -> Vec<u32> {
    let ScreenLevel {
        side,
        across,
        is_root,
        parent_across,
        ..
    } = level.split;
    let words = flat.tile_words;
    let mut masks = Vec::with_capacity((level.tiles() * words) as usize);
    for (x, y) in (0..level.down).flat_map(|y| (0..across).map(move |x| (x, y))) {
        let cone = cone_of_tile(flat, x * side, y * side, side);
        let parent = (y / 2) * parent_across + x / 2;
        masks.extend((0..words).map(|word| {
            let candidates = if is_root == 1 {
                all_of_word(word, flat.volumes.len() as u32)
            } else {
                above[(parent * words + word) as usize]
            };
            met_by_cone(flat, &cone, word, candidates)
        }));
    }
    masks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn masks_fit_what_every_device_has() {
        assert_eq!(words_of_tile([1000, 1000], 2), 1);
        assert_eq!(words_of_tile([1000, 1000], 33), 2);
        for (size, volumes) in [
            ([32768, 32768], 1 << 20),
            ([32768, 8], 1 << 20),
            ([8, 32768], u32::MAX),
            ([1, 1], 1 << 20),
        ] {
            let words = words_of_tile(size, volumes);
            assert!(words > 0, "{size:?}");
            let levels = levels(size, words);
            let root = levels[levels.len() - 1].split;
            assert!(root.first + words <= MOST_WORDS, "{size:?}");
            let across = levels[0].split.across * words;
            assert!(across.div_ceil(64) <= 65_535, "{size:?}");
        }
    }

    #[test]
    fn levels_halve_the_tiles() {
        let levels = levels([100, 33], 3);
        let shapes: Vec<_> = levels
            .iter()
            .map(|l| (l.split.side, l.split.across, l.down, l.split.first))
            .collect();
        assert_eq!(
            shapes,
            [
                (8, 13, 5, 0),
                (16, 7, 3, 195),
                (32, 4, 2, 258),
                (64, 2, 1, 282),
                (128, 1, 1, 288)
            ]
        );
        assert_eq!(levels[1].split.parent_across, 4);
        assert_eq!(levels[1].split.parent_first, 258);
        let roots: Vec<_> = levels.iter().map(|l| l.split.is_root).collect();
        assert_eq!(roots, [0, 0, 0, 0, 1]);
        assert_eq!(super::levels([8, 5], 1).len(), 1);
    }
}

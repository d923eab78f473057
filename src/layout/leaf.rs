//! A leaf in one word: what stands in a [`super::Pair`] in place of a pair's index.

use super::{LEAF, LEAF_COUNT, LEAF_KIND};

/// The leaf of so many primitives of a kind, from a row of its table on.
#[inline]
pub fn leaf_of(kind: u32, count: u32, first: u32) -> u32 {
    LEAF | kind << LEAF_KIND | (count - 1) << LEAF_COUNT | first
}

/// Kind, count and first row of a leaf.
#[inline]
pub fn leaf_parts(leaf: u32) -> (u32, u32, u32) {
    (
        (leaf >> LEAF_KIND) & 3,
        ((leaf >> LEAF_COUNT) & 7) + 1,
        leaf & ((1 << LEAF_COUNT) - 1),
    )
}

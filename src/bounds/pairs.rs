//! The tree as the shaders read it: 32 bytes for two boxes and two children.
//!
//! A pair's planes are whole steps from an origin, in bytes, and the step is the
//! smallest power of two with which 255 of them span both boxes. Boxes grow by less
//! than a step a side. Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on
//! GPUs Through Compressed Wide BVHs", HPG 2017, section 3.1, with two children and
//! an origin in steps, so that a decoded plane is not rounded.

use rayon::prelude::*;

use super::tree::{Node, Tree};
use crate::flat::Kind;
use crate::kernel::aabb::Aabb;
use crate::layout::{Pair, leaf_of};

/// Steps of a pair's extent at most: what a byte holds.
const STEPS: f64 = 255.0;

/// The origin's magnitude in steps at most: what 24 bits hold.
const FARTHEST: f64 = 8_388_607.0;

/// The bias of an f32's exponent.
const BIAS: i32 = 127;

/// Fewer pairs than this are not worth threads.
const PARALLEL: usize = 4096;

/// Packs a tree. `place` tells the kind and the first row of the leaf whose ids
/// begin at an index.
pub fn pack_pairs(tree: &Tree, place: impl Fn(u32) -> (Kind, u32) + Sync) -> Vec<Pair> {
    // Pairs stand in the order of the nodes whose children they are.
    let mut pair_of = vec![0; tree.nodes.len()];
    let mut inner = Vec::new();
    for (node, pair) in tree.nodes.iter().zip(&mut pair_of) {
        if node.count == 0 {
            *pair = inner.len() as u32;
            inner.push(node.first as usize);
        }
    }
    let child = |index: usize| {
        let node = &tree.nodes[index];
        if node.count == 0 {
            return pair_of[index];
        }
        let (kind, row) = place(node.first);
        leaf_of(kind as u32, node.count, row)
    };
    let packed = |&left: &usize| {
        let [low, high] = [left, left + 1];
        pair(&tree.nodes[low], &tree.nodes[high], child(low), child(high))
    };
    // Few are packed before threads have started.
    if inner.len() < PARALLEL {
        return inner.iter().map(packed).collect();
    }
    inner.par_iter().map(packed).collect()
}

fn pair(left: &Node, right: &Node, left_child: u32, right_child: u32) -> Pair {
    let [left_box, right_box] = [left.aabb, right.aabb].map(planes);
    let axis = |axis: usize| quantise(left_box[axis], right_box[axis]);
    Pair {
        x: axis(0),
        y: axis(1),
        z: axis(2),
        left: left_child,
        right: right_child,
    }
}

/// The low and the high plane across each axis.
fn planes(aabb: Aabb) -> [[f64; 2]; 3] {
    let low: [f32; 3] = aabb.low.into();
    let high: [f32; 3] = aabb.high.into();
    std::array::from_fn(|axis| [f64::from(low[axis]), f64::from(high[axis])])
}

/// Both boxes across one axis, rounded outward, as a [`Pair`] has them.
fn quantise(left: [f64; 2], right: [f64; 2]) -> [u32; 2] {
    let low = left[0].min(right[0]);
    let high = left[1].max(right[1]);
    // The exponent of the extent is at most that of 255 steps; of no extent, the least.
    let extent = (high - low) / STEPS;
    let exponent = extent.log2().ceil() as i32;
    let mut exponent = exponent.saturating_sub(1).clamp(1 - BIAS, BIAS);
    loop {
        // Powers of two: no quotient is rounded.
        let step = f64::powi(2.0, exponent);
        let origin = (low / step).floor();
        let fits = (high / step).ceil() - origin <= STEPS && origin.abs() <= FARTHEST;
        if fits || exponent == BIAS {
            let below = |plane: f64| ((plane / step).floor() - origin) as u32;
            let above = |plane: f64| ((plane / step).ceil() - origin) as u32;
            let offsets = [
                below(left[0]),
                above(left[1]),
                below(right[0]),
                above(right[1]),
            ];
            let biased = (exponent + BIAS) as u32;
            return [
                biased << 24 | (origin as i32 as u32 & 0x00ff_ffff),
                offsets[0] | offsets[1] << 8 | offsets[2] << 16 | offsets[3] << 24,
            ];
        }
        exponent += 1;
    }
}

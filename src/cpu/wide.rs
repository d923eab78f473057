//! The tree as the CPU walks it: eight boxes a node, tested at once.
//!
//! Made of the pairs of the scene's tree, by opening the largest children first:
//! Wald, Benthin, Boulos, "Getting Rid of Packets", IEEE Symposium on Interactive Ray
//! Tracing, 2008. The boxes are the primitives' own, united anew, not the pairs'
//! quantised ones.

use rayon::prelude::*;

use super::block::{Block, LANES};
use crate::bounds::box_of_row;
use crate::flat::{Flat, Kind};
use crate::kernel::aabb::Aabb;
use crate::kernel::real::Real;
use crate::kernel::vector::Vec3;
use crate::layout::{LEAF, NOWHERE, Pair, leaf_of, leaf_parts};

/// Children of a node.
pub const WIDTH: usize = 8;

/// Fewer pairs or blocks than this are not worth threads.
const PARALLEL: usize = 4096;

/// Boxes and children of a node; places without a child have a box that no ray meets.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub struct Node {
    /// Of each axis, the low planes, then the high ones.
    pub planes: [[[f32; WIDTH]; 2]; 3],
    /// A node's index, or a leaf: as in a [`crate::layout::Pair`], but a leaf of
    /// triangles gives its [`Block`] in place of a row.
    pub children: [u32; WIDTH],
}

/// The tree.
#[derive(Debug, Clone)]
pub struct Wide<R> {
    /// The root first.
    pub nodes: Vec<Node>,
    /// The leaves of triangles.
    pub blocks: Vec<Block<R>>,
    /// How many entries a search may have to keep waiting.
    pub waiting: usize,
}

/// What is below a child of a pair.
#[derive(Debug, Clone, Copy)]
struct Branch {
    aabb: Aabb,
    /// A pair's index or a leaf.
    child: u32,
    /// How many primitives, and where the first one stands in its kind's table; none
    /// where they are of several kinds.
    rows: Option<(u32, u32)>,
    kind: u32,
}

impl Branch {
    /// First row and count, if it is, or can become, one leaf.
    fn leaf(&self) -> Option<(u32, u32)> {
        self.rows.filter(|&(_, count)| count as usize <= LANES)
    }
}

impl<R: Real> Wide<R> {
    /// Widens the tree of a scene, which has one.
    pub fn new(flat: &Flat<R>) -> Self {
        let mut widening = Widening {
            branches: branches(flat),
            nodes: Vec::with_capacity(flat.pairs.len() / 4),
            blocks: Vec::with_capacity(flat.pairs.len()),
            levels: 0,
        };
        widening.push(0, 1);
        let block = |&(first, count): &(u32, u32)| Block::new(flat, first, count);
        Self {
            nodes: widening.nodes,
            blocks: if widening.blocks.len() < PARALLEL {
                widening.blocks.iter().map(block).collect()
            } else {
                widening.blocks.par_iter().map(block).collect()
            },
            waiting: widening.levels * (WIDTH - 1) + 1,
        }
    }
}

/// A tree that is being widened.
struct Widening {
    branches: Vec<[Branch; 2]>,
    nodes: Vec<Node>,
    /// First row and count of each leaf of triangles.
    blocks: Vec<(u32, u32)>,
    levels: usize,
}

impl Widening {
    /// Adds the node of a pair, `level` levels deep, and all below it; gives its index.
    fn push(&mut self, pair: u32, level: usize) -> u32 {
        self.levels = self.levels.max(level);
        let children = self.children(pair);
        let index = self.nodes.len();
        self.nodes.push(Node::empty());
        for (place, branch) in children.iter().enumerate() {
            let child = match branch.leaf() {
                Some((first, count)) => self.leaf(branch.kind, first, count),
                None => self.push(branch.child, level + 1),
            };
            self.nodes[index].set(place, branch.aabb, child);
        }
        index as u32
    }

    /// What is below a pair when the largest is opened as long as there is room.
    fn children(&self, pair: u32) -> Vec<Branch> {
        let mut children = Vec::with_capacity(WIDTH);
        children.extend(self.branches[pair as usize]);
        while children.len() < WIDTH {
            let Some(largest) = largest_to_open(&children) else {
                break;
            };
            let [left, right] = self.branches[children[largest].child as usize];
            children[largest] = left;
            children.push(right);
        }
        children
    }

    fn leaf(&mut self, kind: u32, first: u32, count: u32) -> u32 {
        if kind != Kind::Triangle as u32 {
            return leaf_of(kind, count, first);
        }
        self.blocks.push((first, count));
        leaf_of(kind, count, self.blocks.len() as u32 - 1)
    }
}

/// What is below both children of each pair.
fn branches<R: Real>(flat: &Flat<R>) -> Vec<[Branch; 2]> {
    let leaves = |pair: &Pair| [pair.left, pair.right].map(|child| leaf_branch(flat, child));
    let mut branches: Vec<[Branch; 2]> = if flat.pairs.len() < PARALLEL {
        flat.pairs.iter().map(leaves).collect()
    } else {
        flat.pairs.par_iter().map(leaves).collect()
    };
    // Children stand after their parents: from the last to the first, all below a pair
    // is known.
    for pair in (0..branches.len()).rev() {
        for side in 0..2 {
            let child = branches[pair][side].child;
            if child & LEAF == 0 {
                branches[pair][side] = joined(branches[child as usize], child);
            }
        }
    }
    branches
}

/// Both branches of a pair as one.
fn joined([left, right]: [Branch; 2], pair: u32) -> Branch {
    let same = left.kind == right.kind;
    let rows = left.rows.zip(right.rows).filter(|_| same);
    Branch {
        aabb: union(left.aabb, right.aabb),
        child: pair,
        rows: rows.map(|((first, a), (_, b))| (first, a + b)),
        kind: left.kind,
    }
}

/// What is in a leaf; of a pair, only its index.
fn leaf_branch<R: Real>(flat: &Flat<R>, leaf: u32) -> Branch {
    let (kind, count, first) = leaf_parts(leaf);
    if leaf & LEAF == 0 {
        return Branch {
            aabb: EMPTY,
            child: leaf,
            rows: None,
            kind,
        };
    }
    let kind_of_leaf = match kind {
        0 => Kind::Sphere,
        1 => Kind::Disk,
        _ => Kind::Triangle,
    };
    let rows = first as usize..(first + count) as usize;
    let boxes = rows.map(|row| box_of_row(flat, kind_of_leaf, row));
    Branch {
        aabb: boxes.reduce(union).expect("a leaf has primitives"),
        child: leaf,
        rows: Some((first, count)),
        kind,
    }
}

fn union(a: Aabb, b: Aabb) -> Aabb {
    let with = |a: Vec3<f32>, b: Vec3<f32>, of: fn(f32, f32) -> f32| Vec3 {
        x: of(a.x, b.x),
        y: of(a.y, b.y),
        z: of(a.z, b.z),
    };
    Aabb {
        low: with(a.low, b.low, f32::min),
        high: with(a.high, b.high, f32::max),
    }
}

/// Holds nothing, and no ray meets it.
const EMPTY: Aabb = Aabb {
    low: Vec3 {
        x: f32::INFINITY,
        y: f32::INFINITY,
        z: f32::INFINITY,
    },
    high: Vec3 {
        x: f32::NEG_INFINITY,
        y: f32::NEG_INFINITY,
        z: f32::NEG_INFINITY,
    },
};

/// The child with the largest surface that is no leaf.
fn largest_to_open(open: &[Branch]) -> Option<usize> {
    let area = |branch: &Branch| {
        let extent = branch.aabb.high - branch.aabb.low;
        extent.x * extent.y + extent.y * extent.z + extent.z * extent.x
    };
    let inner = open
        .iter()
        .enumerate()
        .filter(|(_, branch)| branch.leaf().is_none());
    inner
        .max_by(|(_, a), (_, b)| area(a).total_cmp(&area(b)))
        .map(|(place, _)| place)
}

impl Node {
    pub(super) fn empty() -> Self {
        let mut node = Self {
            planes: Default::default(),
            children: [NOWHERE; WIDTH],
        };
        for place in 0..WIDTH {
            node.set(place, EMPTY, NOWHERE);
        }
        node
    }

    pub(super) fn set(&mut self, place: usize, aabb: Aabb, child: u32) {
        let (low, high): ([f32; 3], [f32; 3]) = (aabb.low.into(), aabb.high.into());
        for (axis, planes) in self.planes.iter_mut().enumerate() {
            planes[0][place] = low[axis];
            planes[1][place] = high[axis];
        }
        self.children[place] = child;
    }
}

//! A bounding volume hierarchy, built top down by the binned surface area
//! heuristic: Wald, "On fast Construction of SAH-based Bounding Volume
//! Hierarchies", IEEE Symposium on Interactive Ray Tracing, 2007.

use crate::kernel::aabb::Aabb;
use crate::kernel::tree::STACK;
use crate::kernel::vector::{Vec3, vec3};
use crate::layout::Pair;

/// Bins an axis is cut into. More than 16 hardly improves a tree (Wald 2007,
/// section 4).
const BINS: usize = 16;

/// Primitives of a leaf at most.
const LEAF: usize = 4;

/// The cost of visiting a pair, in shape tests: two boxes and a stack.
const VISIT: f32 = 1.0;

/// The depth from which on halves are split by count, so that the whole stays
/// within the traversal's stack: 32 more levels hold any count of 32 bits.
const DEEP: usize = STACK - 32;

/// Fewer primitives than this are not worth a thread of their own.
const PARALLEL: usize = 4096;

/// A box with its primitive's id.
type Item = (Aabb, u32);

/// A finished tree.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tree {
    /// Inner nodes, the root first.
    pub pairs: Vec<Pair>,
    /// The primitives of the leaves.
    pub leaf_ids: Vec<u32>,
}

/// A node on the way to its place in the arrays.
enum Node {
    Leaf(Aabb, Vec<u32>),
    Inner(Aabb, Box<[Node; 2]>),
}

/// Builds a tree over the boxes; an empty one over fewer than two, which no volume
/// helps.
pub fn build(mut items: Vec<Item>) -> Tree {
    let mut tree = Tree::default();
    if let Node::Inner(_, children) = subtree(&mut items, 0) {
        tree.pairs.push(Pair::default());
        place(&mut tree, 0, *children);
    }
    tree
}

fn subtree(items: &mut [Item], depth: usize) -> Node {
    let bounds = items.iter().fold(EMPTY, |sum, (aabb, _)| union(sum, *aabb));
    let leaf = |items: &[Item]| Node::Leaf(bounds, items.iter().map(|(_, id)| *id).collect());
    if items.len() < 2 {
        return leaf(items);
    }
    // The root is a pair in any case.
    let small = items.len() <= LEAF && depth > 0;
    let middle = match if depth < DEEP {
        best_split(items, bounds)
    } else {
        None
    } {
        Some(split) if small && split.cost >= items.len() as f32 => {
            return leaf(items);
        }
        Some(split) => partition(items, &split),
        None if small => return leaf(items),
        // Equal centroids, or too deep: any half is as good.
        None => items.len() / 2,
    };
    let large = items.len() > PARALLEL;
    let (left, right) = items.split_at_mut(middle);
    let children = if large {
        let (left, right) = rayon::join(|| subtree(left, depth + 1), || subtree(right, depth + 1));
        [left, right]
    } else {
        [subtree(left, depth + 1), subtree(right, depth + 1)]
    };
    Node::Inner(bounds, Box::new(children))
}

/// A plane between two bins.
struct Split {
    axis: usize,
    /// The smallest centroid, twice.
    start: f32,
    /// From twice a centroid, less `start`, to its bin.
    scale: f32,
    /// The first bin on the right.
    bin: usize,
    /// In shape tests.
    cost: f32,
}

/// The cheapest split, unless all centroids coincide.
fn best_split(items: &[Item], bounds: Aabb) -> Option<Split> {
    let mut low = [f32::MAX; 3];
    let mut high = [f32::MIN; 3];
    for (aabb, _) in items {
        let center = twice_center(aabb);
        for axis in 0..3 {
            low[axis] = low[axis].min(center[axis]);
            high[axis] = high[axis].max(center[axis]);
        }
    }
    let whole = half_area(bounds);
    let mut best: Option<Split> = None;
    for axis in 0..3 {
        let scale = BINS as f32 * (1.0 - f32::EPSILON) / (high[axis] - low[axis]);
        if !(scale > 0.0 && scale.is_finite()) {
            continue;
        }
        let mut bins = [(EMPTY, 0usize); BINS];
        for (aabb, _) in items {
            let bin = bin_of(twice_center(aabb)[axis], low[axis], scale);
            bins[bin] = (union(bins[bin].0, *aabb), bins[bin].1 + 1);
        }
        let mut right_costs = [0.0; BINS];
        let mut sum = (EMPTY, 0);
        for bin in (1..BINS).rev() {
            sum = (union(sum.0, bins[bin].0), sum.1 + bins[bin].1);
            right_costs[bin] = half_area(sum.0) * sum.1 as f32;
        }
        let mut sum = (EMPTY, 0);
        for bin in 1..BINS {
            sum = (union(sum.0, bins[bin - 1].0), sum.1 + bins[bin - 1].1);
            if sum.1 == 0 || sum.1 == items.len() {
                continue;
            }
            let cost = VISIT + (half_area(sum.0) * sum.1 as f32 + right_costs[bin]) / whole;
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                best = Some(Split {
                    axis,
                    start: low[axis],
                    scale,
                    bin,
                    cost,
                });
            }
        }
    }
    best
}

fn bin_of(twice_center: f32, start: f32, scale: f32) -> usize {
    (((twice_center - start) * scale) as usize).min(BINS - 1)
}

/// Moves what lies left of the split to the front, and counts it.
fn partition(items: &mut [Item], split: &Split) -> usize {
    let mut middle = 0;
    for index in 0..items.len() {
        let center = twice_center(&items[index].0)[split.axis];
        if bin_of(center, split.start, split.scale) < split.bin {
            items.swap(index, middle);
            middle += 1;
        }
    }
    middle
}

/// Writes a pair's children, and their children, into the arrays.
fn place(tree: &mut Tree, at: usize, children: [Node; 2]) {
    let [left, right] = children;
    let (left_box, left_child, left_count, left_inner) = reference(tree, left);
    let (right_box, right_child, right_count, right_inner) = reference(tree, right);
    tree.pairs[at] = Pair {
        left_low: left_box.low.into(),
        left: left_child,
        left_high: left_box.high.into(),
        left_count,
        right_low: right_box.low.into(),
        right: right_child,
        right_high: right_box.high.into(),
        right_count,
    };
    if let Some(children) = left_inner {
        place(tree, left_child as usize, *children);
    }
    if let Some(children) = right_inner {
        place(tree, right_child as usize, *children);
    }
}

/// A child as a pair refers to it: its box, index and count, and its children.
fn reference(tree: &mut Tree, node: Node) -> (Aabb, u32, u32, Option<Box<[Node; 2]>>) {
    match node {
        Node::Leaf(bounds, ids) => {
            let first = tree.leaf_ids.len() as u32;
            tree.leaf_ids.extend(&ids);
            (bounds, first, ids.len() as u32, None)
        }
        Node::Inner(bounds, children) => {
            tree.pairs.push(Pair::default());
            (bounds, tree.pairs.len() as u32 - 1, 0, Some(children))
        }
    }
}

/// The box of no points, which no ray meets.
const EMPTY: Aabb = Aabb {
    low: Vec3 {
        x: f32::MAX,
        y: f32::MAX,
        z: f32::MAX,
    },
    high: Vec3 {
        x: f32::MIN,
        y: f32::MIN,
        z: f32::MIN,
    },
};

fn union(a: Aabb, b: Aabb) -> Aabb {
    Aabb {
        low: vec3(
            a.low.x.min(b.low.x),
            a.low.y.min(b.low.y),
            a.low.z.min(b.low.z),
        ),
        high: vec3(
            a.high.x.max(b.high.x),
            a.high.y.max(b.high.y),
            a.high.z.max(b.high.z),
        ),
    }
}

fn half_area(aabb: Aabb) -> f32 {
    let size = aabb.high - aabb.low;
    size.x * size.y + size.y * size.z + size.z * size.x
}

fn twice_center(aabb: &Aabb) -> [f32; 3] {
    (aabb.low + aabb.high).into()
}

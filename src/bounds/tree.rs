//! A bounding volume hierarchy, built top down by the binned surface area
//! heuristic: Wald, "On fast Construction of SAH-based Bounding Volume
//! Hierarchies", IEEE Symposium on Interactive Ray Tracing, 2007.

use crate::flat::Kind;
use crate::kernel::aabb::Aabb;
use crate::kernel::tree::STACK;
use crate::kernel::vector::{Vec3, vec3};

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

/// A node of a tree.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// Holds all below it.
    pub aabb: Aabb,
    /// A leaf's first index into [`Tree::ids`]; else the index of the left child,
    /// which the right one follows.
    pub first: u32,
    /// How many ids a leaf has; 0 where the node is none.
    pub count: u32,
}

/// A finished tree.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tree {
    /// The root first, siblings side by side.
    pub nodes: Vec<Node>,
    /// The primitives of the leaves; those of one leaf are of one kind.
    pub ids: Vec<u32>,
}

/// A node on the way to its place in the arrays.
enum Draft {
    Leaf(Aabb, Vec<u32>),
    Inner(Aabb, Box<[Draft; 2]>),
}

/// Builds a tree over the boxes; an empty one over fewer than two, which no volume
/// helps.
pub fn build(mut items: Vec<Item>, kind_of: &(dyn Fn(u32) -> Kind + Sync)) -> Tree {
    let mut tree = Tree::default();
    if items.len() > 1 {
        let root = subtree(&mut items, 0, kind_of);
        tree.nodes.push(UNPLACED);
        place(&mut tree, 0, root);
    }
    tree
}

fn subtree(items: &mut [Item], depth: usize, kind_of: &(dyn Fn(u32) -> Kind + Sync)) -> Draft {
    let bounds = items.iter().fold(EMPTY, |sum, (aabb, _)| union(sum, *aabb));
    let leaf = |items: &[Item]| Draft::Leaf(bounds, items.iter().map(|(_, id)| *id).collect());
    if items.len() < 2 {
        return leaf(items);
    }
    // The root is a pair in any case.
    let kind = kind_of(items[0].1);
    let small =
        items.len() <= LEAF && depth > 0 && items.iter().all(|item| kind_of(item.1) == kind);
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
        // Equal centroids, or too deep: any half is as good, and of few, each kind.
        None => {
            items.sort_unstable_by_key(|item| kind_of(item.1));
            let other = items.partition_point(|item| kind_of(item.1) == kind_of(items[0].1));
            if items.len() <= LEAF && other < items.len() {
                other
            } else {
                items.len() / 2
            }
        }
    };
    let large = items.len() > PARALLEL;
    let (left, right) = items.split_at_mut(middle);
    let children = if large {
        let (left, right) = rayon::join(
            || subtree(left, depth + 1, kind_of),
            || subtree(right, depth + 1, kind_of),
        );
        [left, right]
    } else {
        [
            subtree(left, depth + 1, kind_of),
            subtree(right, depth + 1, kind_of),
        ]
    };
    Draft::Inner(bounds, Box::new(children))
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

/// Writes a node, and all below it, into the arrays.
fn place(tree: &mut Tree, at: usize, draft: Draft) {
    match draft {
        Draft::Leaf(aabb, ids) => {
            tree.nodes[at] = Node {
                aabb,
                first: tree.ids.len() as u32,
                count: ids.len() as u32,
            };
            tree.ids.extend(&ids);
        }
        Draft::Inner(aabb, children) => {
            let first = tree.nodes.len();
            tree.nodes[at] = Node {
                aabb,
                first: first as u32,
                count: 0,
            };
            tree.nodes.extend([UNPLACED; 2]);
            let [left, right] = *children;
            place(tree, first, left);
            place(tree, first + 1, right);
        }
    }
}

/// What a node is until it is written.
const UNPLACED: Node = Node {
    aabb: EMPTY,
    first: 0,
    count: 0,
};

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

//! A bounding volume hierarchy, built top down by the binned surface area
//! heuristic: Wald, "On fast Construction of SAH-based Bounding Volume
//! Hierarchies", IEEE Symposium on Interactive Ray Tracing, 2007.
//!
//! A node's primitives are moved within their part of one array, and what is below a
//! node of n primitives has its own 2n - 2 places among the nodes. So threads share
//! nothing, and the tree does not depend on them.

use bytemuck::{Pod, Zeroable};

use super::item::Item;
use super::split::{Half, best_split, divide_items};
use crate::flat::Kind;
use crate::kernel::aabb::Aabb;
use crate::kernel::tree::STACK;
use crate::kernel::vector::Vec3;

/// Primitives of a leaf at most.
const LEAF: usize = 4;

/// The depth from which on halves are split by count, so that the whole stays
/// within the traversal's stack: 32 more levels hold any count of 32 bits.
const DEEP: usize = STACK - 32;

/// Fewer primitives than this are not worth a thread of their own.
const PARALLEL: usize = 4096;

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
    /// The root first, siblings side by side, after their parent.
    pub nodes: Vec<Node>,
    /// The primitives of the leaves; those of one leaf are of one kind. All below a
    /// node are side by side.
    pub ids: Vec<u32>,
}

/// A place for a node. All zero where there is none: the first children are at 1.
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct Slot {
    low: [f32; 3],
    first: u32,
    high: [f32; 3],
    count: u32,
}

/// A node still to be built, of `items`, and where it and all below it go.
struct Task<'a> {
    items: &'a mut [Item],
    /// The index of the first item.
    first: u32,
    half: Half,
    depth: usize,
    slot: &'a mut Slot,
    below: &'a mut [Slot],
    /// The index of the first slot below.
    first_below: u32,
}

/// Builds a tree over the boxes; an empty one over fewer than two, which no volume
/// helps.
pub fn build(items: Vec<(Aabb, u32)>, kind_of: &(dyn Fn(u32) -> Kind + Sync)) -> Tree {
    if items.len() < 2 {
        return Tree::default();
    }
    let mut items: Vec<Item> = items.into_iter().map(Item::new).collect();
    let mut slots: Vec<Slot> = bytemuck::zeroed_vec(2 * items.len() - 1);
    let (root, below) = slots.split_at_mut(1);
    let half = Half::of_many(&items);
    grow(
        Task {
            items: &mut items,
            first: 0,
            half,
            depth: 0,
            slot: &mut root[0],
            below,
            first_below: 1,
        },
        kind_of,
    );
    Tree {
        nodes: compact(&slots),
        ids: items.iter().map(Item::id).collect(),
    }
}

fn grow(task: Task<'_>, kind_of: &(dyn Fn(u32) -> Kind + Sync)) {
    let Some((left, right)) = divide_task(task, kind_of) else {
        return;
    };
    if left.items.len() + right.items.len() > PARALLEL {
        rayon::join(|| grow(left, kind_of), || grow(right, kind_of));
    } else {
        grow(left, kind_of);
        grow(right, kind_of);
    }
}

/// Writes a node, and gives what is to become its children unless it is a leaf.
fn divide_task<'a>(
    task: Task<'a>,
    kind_of: &(dyn Fn(u32) -> Kind + Sync),
) -> Option<(Task<'a>, Task<'a>)> {
    let Task { items, half, .. } = task;
    let aabb = half.bounds.aabb();
    *task.slot = Slot {
        low: aabb.low.into(),
        first: task.first,
        high: aabb.high.into(),
        count: items.len() as u32,
    };
    if items.len() == 1 {
        return None;
    }
    // The root is a pair in any case.
    let small = items.len() <= LEAF && task.depth > 0 && of_one_kind(items, kind_of);
    let split = if task.depth < DEEP {
        best_split(items, &half)
    } else {
        None
    };
    let (middle, left, right) = match split {
        Some((_, cost)) if small && cost >= items.len() as f32 => return None,
        Some((split, _)) => divide_items(items, &split),
        None if small => return None,
        None => halve(items, &half, kind_of),
    };
    (task.slot.first, task.slot.count) = (task.first_below, 0);
    let (left_items, right_items) = items.split_at_mut(middle);
    let (children, below) = task.below.split_at_mut(2);
    let [left_slot, right_slot] = children else {
        unreachable!("two slots were split off")
    };
    let beyond = 2 * middle - 2;
    let (left_below, right_below) = below.split_at_mut(beyond);
    Some((
        Task {
            items: left_items,
            first: task.first,
            half: left,
            depth: task.depth + 1,
            slot: left_slot,
            below: left_below,
            first_below: task.first_below + 2,
        },
        Task {
            items: right_items,
            first: task.first + middle as u32,
            half: right,
            depth: task.depth + 1,
            slot: right_slot,
            below: right_below,
            first_below: task.first_below + 2 + beyond as u32,
        },
    ))
}

fn of_one_kind(items: &[Item], kind_of: &(dyn Fn(u32) -> Kind + Sync)) -> bool {
    let kind = kind_of(items[0].id());
    items.iter().all(|item| kind_of(item.id()) == kind)
}

/// Splits equal middles, or what is too deep, by count along the longest axis; of few,
/// splits off a kind.
fn halve(
    items: &mut [Item],
    half: &Half,
    kind_of: &(dyn Fn(u32) -> Kind + Sync),
) -> (usize, Half, Half) {
    let extent = |axis: usize| half.centers.high[axis] - half.centers.low[axis];
    let axis = (0..3).fold(0, |longest, axis| {
        if extent(axis) > extent(longest) {
            axis
        } else {
            longest
        }
    });
    let mut middle = items.len() / 2;
    if items.len() <= LEAF && !of_one_kind(items, kind_of) {
        items.sort_unstable_by_key(|item| (kind_of(item.id()), item.id()));
        let kind = kind_of(items[0].id());
        middle = items.partition_point(|item| kind_of(item.id()) == kind);
    } else {
        items.select_nth_unstable_by(middle, |a, b| {
            let (at_a, at_b) = (a.twice_center()[axis], b.twice_center()[axis]);
            at_a.total_cmp(&at_b).then(a.id().cmp(&b.id()))
        });
    }
    let (left, right) = items.split_at(middle);
    (middle, Half::of(left), Half::of(right))
}

/// Leaves out the slots that no node took: those below leaves of several primitives.
fn compact(slots: &[Slot]) -> Vec<Node> {
    let is_taken = |slot: &Slot| slot.first > 0 || slot.count > 0;
    let mut taken = 1;
    let places: Vec<u32> = slots[1..]
        .chunks_exact(2)
        .map(|pair| {
            let place = taken;
            taken += if is_taken(&pair[0]) { 2 } else { 0 };
            place
        })
        .collect();
    let mut nodes = Vec::with_capacity(taken as usize);
    nodes.extend(slots.iter().filter(|slot| is_taken(slot)).map(|slot| Node {
        aabb: Aabb {
            low: Vec3::from(slot.low),
            high: Vec3::from(slot.high),
        },
        first: if slot.count == 0 {
            places[slot.first as usize / 2]
        } else {
            slot.first
        },
        count: slot.count,
    }));
    nodes
}

//! Proof that a built tree holds what it should.

use crate::kernel::aabb::Aabb;
use crate::kernel::tree::STACK;
use crate::kernel::vector::Vec3;
use crate::layout::Pair;

use super::tree::Tree;

/// Checks a tree over `items`: every primitive is in exactly one leaf, every box
/// holds what is below it, every pair is reached once, and no path is deeper than
/// the traversal's stack.
///
/// # Errors
///
/// The first fault, in words.
pub fn validate(tree: &Tree, items: &[(Aabb, u32)]) -> Result<(), String> {
    if tree.pairs.is_empty() {
        let few = items.len() < 2 && tree.leaf_ids.is_empty();
        return if few {
            Ok(())
        } else {
            Err("a tree without a root has primitives".into())
        };
    }
    let mut check = Check {
        tree,
        visited: vec![false; tree.pairs.len()],
        found: std::collections::HashMap::new(),
    };
    check.pair(0, 1)?;
    if let Some(pair) = check.visited.iter().position(|visited| !visited) {
        return Err(format!("pair {pair} is not reached"));
    }
    for (aabb, id) in items {
        match check.found.remove(id) {
            None => return Err(format!("primitive {id} is in no leaf")),
            Some(leaf) if !holds(leaf, *aabb) => {
                return Err(format!("primitive {id} sticks out of its leaf"));
            }
            Some(_) => {}
        }
    }
    match check.found.keys().next() {
        Some(id) => Err(format!("a leaf holds primitive {id}, which has no box")),
        None => Ok(()),
    }
}

struct Check<'a> {
    tree: &'a Tree,
    visited: Vec<bool>,
    /// The box of the leaf in which a primitive was found.
    found: std::collections::HashMap<u32, Aabb>,
}

impl Check<'_> {
    /// Checks a pair and all below it, and gives the boxes of its two children.
    fn pair(&mut self, at: u32, depth: usize) -> Result<[Aabb; 2], String> {
        if depth > STACK {
            return Err(format!("pair {at} is deeper than {STACK}"));
        }
        let pair = *self
            .tree
            .pairs
            .get(at as usize)
            .ok_or(format!("there is no pair {at}"))?;
        if std::mem::replace(&mut self.visited[at as usize], true) {
            return Err(format!("pair {at} is reached twice"));
        }
        let boxes = children(&pair);
        for (aabb, child, count) in [
            (boxes[0], pair.left, pair.left_count),
            (boxes[1], pair.right, pair.right_count),
        ] {
            if count > 0 {
                self.leaf(aabb, child, count)?;
            } else {
                let below = self.pair(child, depth + 1)?;
                if below.iter().any(|inner| !holds(aabb, *inner)) {
                    return Err(format!("a child of pair {child} sticks out of its box"));
                }
            }
        }
        Ok(boxes)
    }

    fn leaf(&mut self, aabb: Aabb, first: u32, count: u32) -> Result<(), String> {
        let ids = self
            .tree
            .leaf_ids
            .get(first as usize..first as usize + count as usize)
            .ok_or(format!(
                "there are no leaf ids {first} to {}",
                first + count
            ))?;
        for id in ids {
            if self.found.insert(*id, aabb).is_some() {
                return Err(format!("primitive {id} is in two leaves"));
            }
        }
        Ok(())
    }
}

fn children(pair: &Pair) -> [Aabb; 2] {
    [
        Aabb {
            low: Vec3::from(pair.left_low),
            high: Vec3::from(pair.left_high),
        },
        Aabb {
            low: Vec3::from(pair.right_low),
            high: Vec3::from(pair.right_high),
        },
    ]
}

/// Whether `inner` lies in `outer`.
fn holds(outer: Aabb, inner: Aabb) -> bool {
    outer.low.x <= inner.low.x
        && outer.low.y <= inner.low.y
        && outer.low.z <= inner.low.z
        && outer.high.x >= inner.high.x
        && outer.high.y >= inner.high.y
        && outer.high.z >= inner.high.z
}

//! Proof that a built tree holds what it should.

use std::collections::HashMap;

use crate::flat::Kind;
use crate::kernel::aabb::Aabb;
use crate::kernel::tree::STACK;
use crate::layout::{LEAF_COUNT, LEAF_KIND};

use super::tree::{Node, Tree};

/// Checks a tree over `items`: every primitive is in exactly one leaf, the leaves
/// are small and of one kind, every box holds what is below it, every node is
/// reached once, and no path is deeper than the traversal's stack.
///
/// # Errors
///
/// The first fault, in words.
pub fn validate(
    tree: &Tree,
    items: &[(Aabb, u32)],
    kind_of: &dyn Fn(u32) -> Kind,
) -> Result<(), String> {
    if tree.nodes.is_empty() {
        let few = items.len() < 2 && tree.ids.is_empty();
        return if few {
            Ok(())
        } else {
            Err("a tree without a root has primitives".into())
        };
    }
    let mut check = Check {
        tree,
        kind_of,
        visited: vec![false; tree.nodes.len()],
        found: HashMap::new(),
    };
    check.node(0, 0)?;
    if let Some(node) = check.visited.iter().position(|visited| !visited) {
        return Err(format!("node {node} is not reached"));
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
    kind_of: &'a dyn Fn(u32) -> Kind,
    visited: Vec<bool>,
    /// The box of the leaf in which a primitive was found.
    found: HashMap<u32, Aabb>,
}

impl Check<'_> {
    /// Checks a node and all below it, and gives its box.
    fn node(&mut self, at: u32, depth: usize) -> Result<Aabb, String> {
        if depth > STACK {
            return Err(format!("node {at} is deeper than {STACK}"));
        }
        let nodes = &self.tree.nodes;
        let node = *nodes
            .get(at as usize)
            .ok_or(format!("there is no node {at}"))?;
        if std::mem::replace(&mut self.visited[at as usize], true) {
            return Err(format!("node {at} is reached twice"));
        }
        if node.count > 0 {
            return self.leaf(node);
        }
        for child in [node.first, node.first + 1] {
            let below = self.node(child, depth + 1)?;
            if !holds(node.aabb, below) {
                return Err(format!("node {child} sticks out of node {at}"));
            }
        }
        Ok(node.aabb)
    }

    fn leaf(&mut self, leaf: Node) -> Result<Aabb, String> {
        let (first, count) = (leaf.first as usize, leaf.count as usize);
        if count > 1 << (LEAF_KIND - LEAF_COUNT) {
            return Err(format!("a leaf has {count} primitives"));
        }
        let ids = self.tree.ids.get(first..first + count);
        let ids = ids.ok_or(format!("there are no ids {first} to {}", first + count))?;
        for id in ids {
            if (self.kind_of)(*id) != (self.kind_of)(ids[0]) {
                return Err(format!("primitives {} and {id} share a leaf", ids[0]));
            }
            if self.found.insert(*id, leaf.aabb).is_some() {
                return Err(format!("primitive {id} is in two leaves"));
            }
        }
        Ok(leaf.aabb)
    }
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

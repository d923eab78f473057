//! The bounding volume hierarchy as it is built and as it is packed.

mod common;

use common::mesh_seen_from;
use common::random::random_scene;
use glam::DVec3;
use rayproof::Scene;
use rayproof::bounds::tree::{Tree, build};
use rayproof::bounds::{Bounds, bound, primitive_boxes, validate};
use rayproof::flat::{Flat, Kind};
use rayproof::flatten::flatten;
use rayproof::kernel::aabb::Aabb;
use rayproof::kernel::tree::children_of;
use rayproof::kernel::vector::Vec3;
use rayproof::layout::{LEAF, LEAF_COUNT, LEAF_KIND};
use rayproof::scene::mesh::Builtin;

fn knot_tree() -> (Tree, Flat<f32>) {
    let mesh = rayproof::scene::mesh::build(Builtin::Knot, 5000);
    let flat = flatten::<f32>(&mesh_seen_from(mesh, DVec3::Z));
    (tree_over(&flat, usize::MAX), flat)
}

/// A tree over the first `count` primitives.
fn tree_over(flat: &Flat<f32>, count: usize) -> Tree {
    let items = primitive_boxes(flat).into_iter().take(count).collect();
    build(items, &|id| flat.kind_of(id).0)
}

fn fault_of(tree: &Tree, flat: &Flat<f32>, count: usize) -> Result<(), String> {
    let items: Vec<_> = primitive_boxes(flat).into_iter().take(count).collect();
    validate(tree, &items, &|id| flat.kind_of(id).0)
}

#[test]
fn built_trees_are_valid() {
    let (tree, flat) = knot_tree();
    fault_of(&tree, &flat, usize::MAX).unwrap();
    for seed in 0..20 {
        let flat = flatten::<f32>(&random_scene(seed, 1.0));
        for count in [0, 1, 2, 3, 5, usize::MAX] {
            fault_of(&tree_over(&flat, count), &flat, count).unwrap();
        }
    }
}

/// The controls: each fault of a tree is found.
#[test]
fn broken_trees_are_not_valid() {
    let (tree, flat) = knot_tree();
    let fault = |spoil: &dyn Fn(&mut Tree)| {
        let mut broken = tree.clone();
        spoil(&mut broken);
        fault_of(&broken, &flat, usize::MAX).unwrap_err()
    };
    let leaf = tree.nodes.iter().position(|node| node.count > 1).unwrap();
    let inner = 1 + tree.nodes[1..]
        .iter()
        .position(|node| node.count == 0)
        .unwrap();
    assert!(fault(&|tree| tree.nodes[leaf].aabb.high.y -= 0.01).contains("sticks out"));
    assert!(fault(&|tree| tree.nodes[inner].aabb.low.x += 0.01).contains("sticks out"));
    assert!(fault(&|tree| tree.nodes[inner].first = 0).contains("reached twice"));
    assert!(fault(&|tree| tree.nodes[inner].first = 1 << 20).contains("there is no node"));
    assert!(fault(&|tree| tree.nodes[leaf].count = 9).contains("a leaf has 9"));
    assert!(fault(&|tree| tree.nodes[leaf].first = 1 << 20).contains("there are no ids"));
    assert!(fault(&|tree| tree.ids[7] = tree.ids[8]).contains("in two leaves"));
    assert!(fault(&|tree| tree.ids[7] = 1 << 20).contains("is in no leaf"));
    let split_leaf = |id| {
        if id % 2 == 0 {
            Kind::Sphere
        } else {
            Kind::Disk
        }
    };
    let items = primitive_boxes(&flat);
    let error = validate(&tree, &items, &split_leaf).unwrap_err();
    assert!(error.contains("share a leaf"), "{error}");
}

/// The packed boxes hold the tree's, at every scale, and hardly more; the leaves are
/// the same.
#[test]
fn pairs_hold_the_tree() {
    let mut scenes: Vec<Scene> = (0..13)
        .map(|seed| random_scene(seed, 10f64.powi(2 * seed as i32 - 12)))
        .collect();
    scenes.push(mesh_seen_from(
        rayproof::scene::mesh::build(Builtin::Knot, 5000),
        DVec3::Z,
    ));
    for scene in scenes {
        let mut flat = flatten::<f32>(&scene);
        let tree = tree_over(&flat, usize::MAX);
        bound(&mut flat, Bounds::Tree);
        let inner: Vec<_> = tree.nodes.iter().filter(|node| node.count == 0).collect();
        assert_eq!(inner.len(), flat.pairs.len());
        for (node, pair) in inner.iter().zip(&flat.pairs) {
            let children = children_of(pair);
            let left = tree.nodes[node.first as usize];
            let right = tree.nodes[node.first as usize + 1];
            assert!(holds(children.left_low, children.left_high, left.aabb));
            assert!(holds(children.right_low, children.right_high, right.aabb));
            let extent = node.aabb.high - node.aabb.low;
            let [x, y, z] = [
                (children.left_low.x, left.aabb.low.x, extent.x),
                (children.left_low.y, left.aabb.low.y, extent.y),
                (children.left_low.z, left.aabb.low.z, extent.z),
            ]
            .map(|(packed, exact, extent)| exact - packed <= extent / 120.0);
            assert!(x && y && z, "{children:?} of {left:?}");
            for (child, node) in [(children.left, left), (children.right, right)] {
                assert_eq!(child & LEAF == 0, node.count == 0);
                if node.count > 0 {
                    let id = tree.ids[node.first as usize];
                    let (kind, _) = flat.kind_of(id);
                    let row = (child & ((1 << LEAF_COUNT) - 1)) as usize;
                    let found = match kind {
                        Kind::Sphere => flat.sphere_ids[row],
                        Kind::Disk => flat.disk_ids[row],
                        Kind::Triangle => flat.triangles[row].id,
                    };
                    assert_eq!(found, id);
                    assert_eq!((child >> LEAF_KIND) & 3, kind as u32);
                }
            }
        }
    }
}

fn holds(low: Vec3<f32>, high: Vec3<f32>, inner: Aabb) -> bool {
    low.x <= inner.low.x
        && low.y <= inner.low.y
        && low.z <= inner.low.z
        && high.x >= inner.high.x
        && high.y >= inner.high.y
        && high.z >= inner.high.z
}

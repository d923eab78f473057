//! The order of shapes changes only their ids.

use std::sync::Arc;

use rayproof::bounds::Bounds;
use rayproof::flatten::flatten_with_ids;
use rayproof::scene::{Geometry, Mesh};
use rayproof::{Accuracy, Backend, Frame, Scene};

use super::common::random::{Numbers, random_scene};
use super::{TIERS, bits_of, gpu_backend, picture, seeds};

/// 0, 1, ... in another order.
fn shuffled(count: usize, n: &mut Numbers) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    for last in (1..count).rev() {
        order.swap(last, n.next() as usize % (last + 1));
    }
    order
}

/// The mesh with its triangles in another order.
fn reordered(mesh: &Mesh, order: &[usize]) -> Mesh {
    fn taken<T: Copy>(from: &[T], order: &[usize]) -> Vec<T> {
        let places = order.iter().filter(|_| !from.is_empty());
        places.map(|&place| from[place]).collect()
    }
    Mesh {
        triangles: taken(&mesh.triangles, order),
        triangle_normals: taken(&mesh.triangle_normals, order),
        triangle_materials: taken(&mesh.triangle_materials, order),
        ..mesh.clone()
    }
}

/// The scene with shapes and triangles in another order, and the ids of its primitives in
/// the first scene.
fn permuted(scene: &Scene, seed: u64) -> (Scene, Vec<u32>) {
    let mut n = Numbers(seed);
    let order = shuffled(scene.shapes.len(), &mut n);
    let mut other = scene.clone();
    other.shapes = order
        .iter()
        .map(|&from| scene.shapes[from].clone())
        .collect();
    let (_, old) = flatten_with_ids::<f64>(scene);
    let (flat, new) = flatten_with_ids::<f64>(&other);
    let mut old_ids = vec![0; flat.primitives() as usize];
    for ((shape, ids), &from) in other.shapes.iter_mut().zip(&new).zip(&order) {
        let turned = shuffled(ids.len(), &mut n);
        if let Geometry::Mesh(mesh) = &mut shape.geometry {
            *mesh = Arc::new(reordered(mesh, &turned));
        }
        for (id, place) in ids.clone().zip(turned) {
            old_ids[id as usize] = old[from].start + place as u32;
        }
    }
    (other, old_ids)
}

/// Pixels that differ, but for ids, and pixels of two primitives at one t.
fn differences(here: &Frame, there: &Frame, old_ids: &[u32]) -> (usize, usize) {
    let mut found = (0, 0);
    for at in 0..here.pixels() {
        let [left, mut right] = [here, there].map(|frame| bits_of(frame, at));
        let id = &mut right[10];
        *id = old_ids.get(*id as usize).copied().unwrap_or(*id);
        if left[10] != right[10] && left[9] == right[9] {
            found.1 += 1;
        } else if left != right {
            found.0 += 1;
        }
    }
    found
}

#[test]
fn the_order_of_shapes_changes_only_ids() {
    let gpu = gpu_backend();
    let (mut ties, mut pixels) = (0, 0);
    for seed in seeds() {
        // Nothing of it is twice in one place.
        let scene = random_scene(seed, 1.0);
        let (other, old_ids) = permuted(&scene, seed);
        for accuracy in TIERS {
            for bounds in [Bounds::Tree, Bounds::None] {
                let here = picture(&scene, &Backend::Cpu(None), accuracy, bounds);
                let there = picture(&other, &Backend::Cpu(None), accuracy, bounds);
                let (differing, tied) = differences(&here, &there, &old_ids);
                assert_eq!(differing, 0, "seed {seed}, {}, {bounds:?}", accuracy.name());
                ties += tied;
                pixels += here.pixels();
                if seed == 0 && bounds == Bounds::Tree {
                    let there = picture(&other, &gpu, accuracy, bounds);
                    let on_gpu = differences(&here, &there, &old_ids);
                    assert_eq!(on_gpu, (0, tied), "{}, on the GPU", accuracy.name());
                }
            }
        }
    }
    // Where two shapes meet, or two triangles, t may round to the same number.
    assert!(ties * 1000 < pixels, "{ties} of {pixels}");
}

/// The control: of shapes in one place the first one is seen.
#[test]
fn the_order_of_shapes_in_one_place_is_noticed() {
    let mut scene = random_scene(0, 1.0);
    let mut twice = scene.shapes.clone();
    for shape in &mut twice {
        shape.material = (shape.material + 1) % 5;
    }
    scene.shapes.extend(twice);
    let mut other = scene.clone();
    other.shapes.rotate_left(scene.shapes.len() / 2);
    let [here, there] = [&scene, &other]
        .map(|scene| picture(scene, &Backend::Cpu(None), Accuracy::Robust, Bounds::Tree));
    let hits = here.id.iter().filter(|id| **id != u32::MAX).count();
    let other_colors = (0..here.pixels()).filter(|&at| here.color[at] != there.color[at]);
    assert!(other_colors.count() > hits * 9 / 10);
}

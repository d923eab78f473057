//! Bounding volumes never change the picture.

mod common;

use std::sync::Arc;

use common::random::random_scene;
use common::{BRUTE_FORCE, assert_same_bits, gpu, scene};
use glam::{DMat3, DVec3};
use rayproof::bounds::tree::{Tree, build};
use rayproof::bounds::{Bounds, bound, primitive_boxes, validate};
use rayproof::flat::{Flat, Kind};
use rayproof::flatten::flatten;
use rayproof::gpu::render::{Portions, render};
use rayproof::kernel::aabb::{Aabb, ball_box, clamp_to_box, triangle_box};
use rayproof::kernel::camera::camera_ray;
use rayproof::kernel::disk::intersect_disk;
use rayproof::kernel::hit::GIVEN_UP;
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::real::Real;
use rayproof::kernel::sphere::intersect_sphere;
use rayproof::kernel::trace::trace_pixel;
use rayproof::kernel::tree::children_of;
use rayproof::kernel::triangle::intersect_triangle;
use rayproof::kernel::triangles::triangle_of;
use rayproof::kernel::vector::Vec3;
use rayproof::layout::{LEAF, LEAF_COUNT, LEAF_KIND, NOWHERE, Pair, Pixel};
use rayproof::render::Settings;
use rayproof::scene::mesh::Builtin;
use rayproof::scene::{Geometry, Material, Mesh, PixelSampling, Shape, Transform};
use rayproof::{Accuracy, Backend, Scene, Unwatched};

const TREE: Settings = Settings {
    accuracy: Accuracy::Robust,
    bounds: Bounds::Tree,
};

/// Renders with and without the tree, on both backends, and compares all layers.
fn assert_tree_changes_nothing(scene: &Scene) {
    let on = |backend: &Backend, settings: Settings| {
        rayproof::render(scene, backend, settings, &Unwatched)
            .unwrap()
            .frame
    };
    let reference = on(&Backend::Cpu(None), BRUTE_FORCE);
    assert_same_bits(&reference, &on(&Backend::Cpu(None), TREE));
    assert_same_bits(&reference, &on(&Backend::Gpu(Box::new(gpu())), TREE));
    let double = |bounds| Settings {
        accuracy: Accuracy::Double,
        bounds,
    };
    assert_same_bits(
        &on(&Backend::Cpu(None), double(Bounds::None)),
        &on(&Backend::Cpu(None), double(Bounds::Tree)),
    );
}

#[test]
fn seed_spheres() {
    assert_tree_changes_nothing(&scene("seed-spheres").with_size(500, 500));
}

#[test]
fn shapes() {
    assert_tree_changes_nothing(&scene("shapes").with_size(300, 300));
}

#[test]
fn seed_models() {
    assert_tree_changes_nothing(&scene("seed-models").with_size(150, 150));
}

#[test]
fn knot() {
    assert_tree_changes_nothing(&scene("knot").with_size(40, 40));
}

fn without_tests(pixel: Pixel) -> Pixel {
    Pixel { tests: 0, ..pixel }
}

/// Pixels that differ between brute force and the tree.
fn changed<R: Real>(scene: &Scene) -> usize {
    let plain = flatten::<R>(scene);
    let mut bounded = plain.clone();
    bound(&mut bounded, Bounds::Tree);
    let [width, height] = plain.size;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    pixels
        .filter(|&(x, y)| {
            let with = trace_pixel(&bounded, x, y);
            assert_ne!(with.tests, GIVEN_UP);
            without_tests(trace_pixel(&plain, x, y)) != without_tests(with)
        })
        .count()
}

#[test]
fn random_scenes_at_every_scale() {
    for seed in 0..60 {
        let exponent = [-12, -6, -3, -1, 0, 0, 1, 3, 6, 12][seed as usize % 10];
        let scene = random_scene(seed, 10f64.powi(exponent));
        assert_eq!(
            changed::<f32>(&scene),
            0,
            "seed {seed}, scale 1e{exponent}, f32"
        );
        assert_eq!(
            changed::<f64>(&scene),
            0,
            "seed {seed}, scale 1e{exponent}, f64"
        );
    }
}

/// A scene of one mesh in front of a camera whose middle rays run along the axes.
fn mesh_scene(mesh: Mesh, eye: DVec3) -> Scene {
    let mut scene = Scene {
        ambient: [1.0; 3],
        materials: vec![Material {
            name: "white".into(),
            albedo: [0.8; 3],
        }],
        shapes: vec![Shape {
            geometry: Geometry::Mesh(Arc::new(mesh)),
            transform: Transform::default(),
            material: 0,
        }],
        ..Scene::default()
    }
    .with_size(32, 32);
    scene.camera.eye = eye;
    scene.camera.target = eye - DVec3::Z;
    scene.camera.sampling = PixelSampling::Corner;
    scene
}

/// Axis-parallel quads: flat boxes, rays along their faces, an eye in their plane.
#[test]
fn flat_boxes_and_rays_along_axes() {
    let mut mesh = Mesh::default();
    for i in 0..200u32 {
        let z = -f64::from(i % 20);
        let (x, y) = (f64::from(i % 7) - 3.0, f64::from(i % 11) - 5.0);
        let first = mesh.positions.len() as u32;
        let side = if i % 2 == 0 { DVec3::Y } else { DVec3::Z };
        let corner = DVec3::new(x, y, z);
        mesh.positions.extend([
            corner,
            corner + DVec3::X,
            corner + side,
            corner + side + DVec3::X,
        ]);
        mesh.triangles.push([first, first + 1, first + 2]);
        mesh.triangles.push([first + 1, first + 3, first + 2]);
    }
    for eye in [
        DVec3::new(0.0, 0.0, 3.0),
        DVec3::ZERO,
        DVec3::new(1.0, -1.0, -4.0),
    ] {
        let scene = mesh_scene(mesh.clone(), eye);
        assert_eq!(changed::<f32>(&scene), 0, "eye {eye}");
        assert_eq!(changed::<f64>(&scene), 0, "eye {eye}");
    }
}

/// The same triangle again and again: the tree is deep, but bounded, and the
/// lowest id wins.
#[test]
fn equal_centroids() {
    let mesh = Mesh {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
        triangles: vec![[0, 1, 2]; 3000],
        ..Mesh::default()
    };
    let scene = mesh_scene(mesh, DVec3::new(0.2, 0.2, 2.0));
    assert_eq!(changed::<f32>(&scene), 0);
    let mut flat = flatten::<f32>(&scene);
    bound(&mut flat, Bounds::Tree);
    assert!((0..32).all(|x| [0, u32::MAX].contains(&trace_pixel(&flat, x, 16).id)));
}

/// Sizes that double from one triangle to the next: a chain in place of a tree.
#[test]
fn exponential_spacing() {
    let mut mesh = Mesh::default();
    for i in 0..60 {
        let size = 2f64.powi(i - 30);
        let first = mesh.positions.len() as u32;
        let corner = DVec3::new(size, size / 3.0, -size);
        mesh.positions
            .extend([corner, corner + DVec3::X * size, corner + DVec3::Y * size]);
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    assert_eq!(changed::<f32>(&mesh_scene(mesh, DVec3::ZERO)), 0);
}

/// Every hit that a shape test accepts lies in the shape's own padded box, and the
/// box moves its t by no more than rounding does.
#[test]
fn own_boxes_lose_no_hit() {
    let mut hits = 0;
    for seed in 0..30 {
        let flat = flatten::<f32>(&random_scene(seed, 10f64.powi(seed as i32 % 7 - 3)));
        for pixel in 0..61 * 47 {
            let probe = probe_of(camera_ray(&flat.camera, flat.size, pixel % 61, pixel / 61));
            for (t, own) in accepted(&flat, probe) {
                let clamped = clamp_to_box(probe.slabs, own, t);
                assert!(
                    (clamped - t).abs() <= 1e-5 * t,
                    "seed {seed}: {t} became {clamped}"
                );
                hits += 1;
            }
        }
    }
    assert!(hits > 50_000, "{hits}");
}

/// All hits of a ray, with the box of the shape.
fn accepted(
    flat: &Flat<f32>,
    probe: rayproof::kernel::probe::Probe<f32>,
) -> Vec<(f32, rayproof::kernel::aabb::Aabb)> {
    let spheres = flat.spheres.iter().map(|sphere| {
        let own = ball_box(Vec3::from(sphere.center), sphere.radius);
        (intersect_sphere(probe.ray, sphere), own)
    });
    let disks = flat.disks.iter().map(|disk| {
        (
            intersect_disk(probe.ray, disk),
            ball_box(Vec3::from(disk.center), disk.radius),
        )
    });
    let triangles = flat.triangles.iter().map(|&corners| {
        let triangle = triangle_of(flat, corners);
        let own = triangle_box(
            Vec3::from(triangle.a),
            Vec3::from(triangle.b),
            Vec3::from(triangle.c),
        );
        (intersect_triangle(probe.ray, probe.shear, &triangle), own)
    });
    spheres
        .chain(disks)
        .chain(triangles)
        .filter(|(t, _)| *t < f32::MISS)
        .collect()
}

fn knot_tree() -> (Tree, Flat<f32>) {
    let mesh = rayproof::scene::mesh::build(Builtin::Knot, 5000);
    let flat = flatten::<f32>(&mesh_scene(mesh, DVec3::Z));
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
    scenes.push(mesh_scene(
        rayproof::scene::mesh::build(Builtin::Knot, 5000),
        DVec3::Z,
    ));
    for scene in scenes {
        let mut flat = flatten::<f32>(&scene);
        bound(&mut flat, Bounds::Tree);
        let inner: Vec<_> = flat
            .tree
            .nodes
            .iter()
            .filter(|node| node.count == 0)
            .collect();
        assert_eq!(inner.len(), flat.pairs.len());
        for (node, pair) in inner.iter().zip(&flat.pairs) {
            let children = children_of(pair);
            let left = flat.tree.nodes[node.first as usize];
            let right = flat.tree.nodes[node.first as usize + 1];
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
                    let id = flat.tree.ids[node.first as usize];
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

/// A tree with a cycle gives up, on both tracers, and does not hang.
#[test]
fn a_cycle_ends() {
    let mesh = rayproof::scene::mesh::build(Builtin::Knot, 2000);
    let scene = mesh_scene(mesh, DVec3::new(0.0, 0.0, 4.0));
    let mut flat = flatten::<f32>(&scene);
    bound(&mut flat, Bounds::Tree);
    // A step of 2^100: the left child, the root again, is everywhere, and the right
    // one a point in the corner.
    let everywhere = [227 << 24 | 0x00ff_ff81, 0xff_ff_ff_00];
    flat.pairs[0] = Pair {
        x: everywhere,
        y: everywhere,
        z: everywhere,
        left: 0,
        right: NOWHERE,
    };
    assert_eq!(trace_pixel(&flat, 0, 0).tests, GIVEN_UP);
    let mut pixels = Vec::new();
    render(
        &gpu(),
        &flat,
        Portions::default(),
        &Unwatched,
        &mut |_, rows| {
            pixels.extend_from_slice(rows);
        },
    )
    .unwrap();
    assert_eq!(pixels[0].tests, GIVEN_UP);
}

/// More than lavapipe's 128 MiB a storage binding: read from a texture, and right.
#[test]
fn a_mesh_past_the_storage_binding() {
    let gpu = gpu();
    let mesh = rayproof::scene::mesh::build(Builtin::Icosphere, 4_000_000);
    let mut flat = flatten::<f32>(&mesh_scene(mesh, DVec3::new(0.0, 0.0, 3.0)));
    bound(&mut flat, Bounds::Tree);
    assert!(flat.bytes() > 128 << 20, "{} bytes", flat.bytes());
    let mut different = 0;
    let mut tests = 0;
    render(
        &gpu,
        &flat,
        Portions::default(),
        &Unwatched,
        &mut |row, rows| {
            for (pixel, index) in rows.iter().zip(0..) {
                let y = row + index / flat.size[0];
                different += u32::from(*pixel != trace_pixel(&flat, index % flat.size[0], y));
                tests += pixel.tests;
            }
        },
    )
    .unwrap();
    assert_eq!(different, 0);
    assert!(tests > 1000, "{tests} shape tests");
}

/// The control of the comparison: a box that is too small loses hits, and that is
/// noticed.
#[test]
fn a_box_that_is_too_small_is_noticed() {
    let scene = Scene {
        shapes: vec![
            Shape {
                geometry: Geometry::Sphere {
                    center: DVec3::new(0.0, 0.0, -3.0),
                    radius: 1.0
                },
                transform: Transform {
                    linear: DMat3::IDENTITY,
                    translate: DVec3::ZERO
                },
                material: 0,
            };
            4
        ],
        materials: vec![Material {
            name: "white".into(),
            albedo: [0.8; 3],
        }],
        ..Scene::default()
    }
    .with_size(64, 64);
    let plain = flatten::<f32>(&scene);
    let mut small = plain.clone();
    bound(&mut small, Bounds::Tree);
    for pair in &mut small.pairs {
        // The origin of the first axis, a few steps further on.
        pair.x[0] = pair.x[0] & !0x00ff_ffff | (pair.x[0] + 70) & 0x00ff_ffff;
    }
    let lost = (0..64 * 64)
        .filter(|pixel| {
            trace_pixel(&plain, pixel % 64, pixel / 64).id
                != trace_pixel(&small, pixel % 64, pixel / 64).id
        })
        .count();
    assert!(lost > 10, "{lost}");
}

//! A finer and finer mesh becomes the sphere.

use std::sync::Arc;

use glam::DVec3;
use rayproof::bounds::Bounds;
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{Geometry, Mesh, Shape, Transform};
use rayproof::{Accuracy, Backend, Frame, Scene};

use super::common::white_scene;
use super::{gpu_backend, picture};

/// Parts of an icosahedron's edges: halved lengths from one to the next.
const PARTS: [u32; 4] = [4, 8, 16, 32];

fn scene_of(geometry: Geometry) -> Scene {
    let transform = Transform {
        translate: DVec3::new(0.1, -0.05, -3.0),
        ..Transform::default()
    };
    let mut scene = white_scene(vec![Shape {
        geometry,
        transform,
        material: 0,
        velocity: DVec3::ZERO,
    }])
    .with_size(80, 80);
    scene.camera.fov_degrees = 30.0;
    scene
}

fn sphere(radius: f64) -> Scene {
    scene_of(Geometry::Sphere {
        center: DVec3::ZERO,
        radius,
    })
}

/// The unit sphere as a mesh, with the normals of its vertices or without.
fn mesh(parts: u32, smooth: bool) -> Mesh {
    let mut mesh = build(Builtin::Icosphere, 20 * parts * parts);
    if !smooth {
        mesh.normals.clear();
        mesh.triangle_normals.clear();
    }
    mesh
}

/// The root mean squares of the errors of depth and of normals, where the sphere is seen
/// at less than 60 degrees: at its outline, depth has no bounded slope.
fn errors(mesh: &Frame, sphere: &Frame) -> [f64; 2] {
    let (mut sums, mut count) = ([0.0, 0.0], 0.0);
    for at in 0..sphere.pixels() {
        let [normal, position, other] = [sphere.normal[at], sphere.position[at], mesh.normal[at]]
            .map(|v| DVec3::from(v.map(f64::from)));
        if normal.dot(position).abs() <= 0.5 * position.length() {
            continue;
        }
        let depth = f64::from(mesh.depth[at]) - f64::from(sphere.depth[at]);
        sums[0] += depth * depth;
        sums[1] += (normal - other).length_squared();
        count += 1.0;
    }
    assert!(count > 1000.0, "{count}");
    sums.map(|sum| (sum / count).sqrt())
}

/// The orders in the edges' length, from each mesh to the next: of depth, then of normals.
fn orders(backend: &Backend, accuracy: Accuracy, smooth: bool, radius: f64) -> Vec<[f64; 2]> {
    let see = |scene: &Scene| picture(scene, backend, accuracy, Bounds::Tree);
    let sphere = see(&sphere(radius));
    let errors: Vec<_> = PARTS
        .map(|parts| {
            let mesh = see(&scene_of(Geometry::Mesh(Arc::new(mesh(parts, smooth)))));
            errors(&mesh, &sphere)
        })
        .to_vec();
    let steps = errors.windows(2);
    steps
        .map(|pair| [0, 1].map(|of| (pair[0][of] / pair[1][of]).log2()))
        .collect()
}

/// Depth is of the second order; normals are of the first where triangles are flat, and of
/// the second where they are interpolated. An order is a whole number.
#[test]
fn a_mesh_becomes_the_sphere() {
    let [cpu, gpu] = [Backend::Cpu(None), gpu_backend()];
    for (backend, accuracy) in [
        (&cpu, Accuracy::Robust),
        (&cpu, Accuracy::Extended),
        (&cpu, Accuracy::Double),
        (&cpu, Accuracy::Adaptive),
        (&gpu, Accuracy::Robust),
    ] {
        for (smooth, of_normals) in [(false, 1.0), (true, 2.0)] {
            for found in orders(backend, accuracy, smooth, 1.0) {
                println!("{} {smooth}: {found:?}", accuracy.name());
                assert_eq!(found.map(f64::round), [2.0, of_normals], "{found:?}");
            }
        }
    }
}

/// The mesh is inscribed: its surface lies between the sphere and one that is smaller by the
/// height of the flattest arc, 1 - root(1 - c^2) for triangles of circumradius c at most. So
/// does each pixel's depth, but for f32's rounding of it.
#[test]
fn depths_lie_between_two_spheres() {
    let see = |scene: &Scene| picture(scene, &Backend::Cpu(None), Accuracy::Double, Bounds::Tree);
    let outer = see(&sphere(1.0));
    for parts in PARTS {
        let mesh = mesh(parts, false);
        let circumradius = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|corner| mesh.positions[corner as usize]);
            let (x, y, z) = (a.distance(b), b.distance(c), c.distance(a));
            x * y * z / (2.0 * (b - a).cross(c - a).length())
        };
        let widest = mesh.triangles.iter().map(circumradius).fold(0.0, f64::max);
        let inner = see(&sphere((1.0 - widest * widest).sqrt()));
        let there = see(&scene_of(Geometry::Mesh(Arc::new(mesh))));
        let mut seen = 0;
        for at in (0..outer.pixels()).filter(|&at| inner.depth[at].is_finite()) {
            let depth = there.depth[at];
            let (near, far) = (outer.depth[at].next_down(), inner.depth[at].next_up());
            assert!(near <= depth && depth <= far, "{depth}: {near} to {far}");
            seen += 1;
        }
        assert!(seen > 1000, "{seen}");
    }
}

/// The control: no mesh becomes a sphere that is a little larger.
#[test]
fn another_radius_is_noticed() {
    let orders = orders(&Backend::Cpu(None), Accuracy::Double, false, 1.01);
    assert!(orders.last().unwrap()[0] < 0.5, "{orders:?}");
}

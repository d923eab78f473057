//! Bounding volumes never change the picture.

mod common;

use common::random::random_scene;
use common::{
    assert_bounds_change_nothing, changed, gpu, mesh_seen_from, scene, sphere_ahead, white_scene,
};
use glam::DVec3;
use rayproof::Unwatched;
use rayproof::bounds::{Bounds, bound};
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::gpu::render::{Portions, render};
use rayproof::kernel::camera::camera_ray;
use rayproof::kernel::disk::intersect_disk;
use rayproof::kernel::hit::GIVEN_UP;
use rayproof::kernel::own_box::{ball_box, clamp_to_box, triangle_box};
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::real::Real;
use rayproof::kernel::sphere::intersect_sphere;
use rayproof::kernel::trace::trace_pixel;
use rayproof::kernel::triangle::intersect_triangle;
use rayproof::kernel::triangles::triangle_of;
use rayproof::kernel::vector::Vec3;
use rayproof::layout::{NOWHERE, Pair};
use rayproof::scene::Mesh;
use rayproof::scene::mesh::Builtin;

#[test]
fn seed_spheres() {
    assert_bounds_change_nothing(&scene("seed-spheres").with_size(500, 500), &[Bounds::Tree]);
}

#[test]
fn shapes() {
    assert_bounds_change_nothing(&scene("shapes").with_size(300, 300), &[Bounds::Tree]);
}

#[test]
fn seed_models() {
    assert_bounds_change_nothing(&scene("seed-models").with_size(150, 150), &[Bounds::Tree]);
}

#[test]
fn knot() {
    assert_bounds_change_nothing(&scene("knot").with_size(40, 40), &[Bounds::Tree]);
}

#[test]
fn random_scenes_at_every_scale() {
    for seed in 0..60 {
        let exponent = [-12, -6, -3, -1, 0, 0, 1, 3, 6, 12][seed as usize % 10];
        let scene = random_scene(seed, 10f64.powi(exponent));
        assert_eq!(
            changed::<f32>(&scene, Bounds::Tree),
            0,
            "seed {seed}, scale 1e{exponent}, f32"
        );
        assert_eq!(
            changed::<f64>(&scene, Bounds::Tree),
            0,
            "seed {seed}, scale 1e{exponent}, f64"
        );
    }
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
        let scene = mesh_seen_from(mesh.clone(), eye);
        assert_eq!(changed::<f32>(&scene, Bounds::Tree), 0, "eye {eye}");
        assert_eq!(changed::<f64>(&scene, Bounds::Tree), 0, "eye {eye}");
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
    let scene = mesh_seen_from(mesh, DVec3::new(0.2, 0.2, 2.0));
    assert_eq!(changed::<f32>(&scene, Bounds::Tree), 0);
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
    assert_eq!(
        changed::<f32>(&mesh_seen_from(mesh, DVec3::ZERO), Bounds::Tree),
        0
    );
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
        let own = ball_box::<f32>(Vec3::from(sphere.center), sphere.radius);
        (intersect_sphere(probe.ray, sphere), own)
    });
    let disks = flat.disks.iter().map(|disk| {
        (
            intersect_disk(probe.ray, disk),
            ball_box::<f32>(Vec3::from(disk.center), disk.radius),
        )
    });
    let triangles = flat.triangles.iter().map(|&corners| {
        let triangle = triangle_of(flat, corners);
        let own = triangle_box::<f32>(
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

/// A tree with a cycle gives up, on both tracers, and does not hang.
#[test]
fn a_cycle_ends() {
    let mesh = rayproof::scene::mesh::build(Builtin::Knot, 2000);
    let scene = mesh_seen_from(mesh, DVec3::new(0.0, 0.0, 4.0));
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
    let mut flat = flatten::<f32>(&mesh_seen_from(mesh, DVec3::new(0.0, 0.0, 3.0)));
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
    let scene = white_scene(vec![sphere_ahead(); 4]).with_size(64, 64);
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

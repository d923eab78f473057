//! Holes in shapes against shapes that have none.

use std::sync::Arc;

use glam::DVec3;
use rayproof::kernel::cutouts::MOST_HOLES;
use rayproof::kernel::offset::OFFSET;
use rayproof::scene::{
    Falloff, Fog, Geometry, Light, Material, Mesh, Pattern, Shape, Texels, Texture, Transform,
};
use rayproof::{Frame, Scene};

use crate::common::{assert_same_bits, on_cpu, on_gpu};

fn shape(geometry: Geometry, material: usize) -> Shape {
    Shape {
        geometry,
        transform: Transform::default(),
        material,
        velocity: DVec3::ZERO,
    }
}

/// A rectangle across the line of sight, with the texture's whole repeat on it.
fn rectangle(x: [f64; 2], y: [f64; 2], z: f64) -> Geometry {
    let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
    let place = |(i, j): (usize, usize)| DVec3::new(x[i], y[j], z);
    let uv = |(i, j)| [f64::from(i), f64::from(j)];
    Geometry::Mesh(Arc::new(Mesh {
        positions: corners.map(place).to_vec(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        uvs: corners.map(|(i, j)| uv((i as u32, j as u32))).to_vec(),
        triangle_uvs: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    }))
}

/// Columns of a white image by turns there and not there, each two texels wide: alpha is 1/2
/// just where a column ends.
fn columns(is_cutout: bool, repeat: f64) -> Material {
    let texel = |alpha| [1.0, 1.0, 1.0, alpha];
    let texels = Texels {
        name: "columns".into(),
        width: 4,
        height: 1,
        texels: [1.0, 1.0, 0.0, 0.0].map(texel).to_vec(),
    };
    Material {
        texture: Some(Texture {
            pattern: Pattern::Image(Arc::new(texels)),
            repeat: [repeat, 1.0],
            size: 1.0,
        }),
        cutout: is_cutout,
        ..Material::default()
    }
}

/// Something in front of a white wall, on which the sun casts its shadow.
fn before_a_wall(materials: Vec<Material>, shapes: Vec<Shape>) -> Scene {
    let wall = Geometry::Plane {
        point: DVec3::new(0.0, 0.0, -6.0),
        normal: DVec3::Z,
    };
    let mut scene = Scene {
        ambient: [0.1, 0.2, 0.3],
        lights: vec![Light::Directional {
            direction: DVec3::new(0.31, 0.17, 1.0),
            color: [0.7; 3],
            shadow: true,
        }],
        materials,
        shapes,
        ..Scene::default()
    }
    .with_size(96, 72);
    scene.shapes.push(shape(wall, 0));
    scene
}

/// Four columns by holes, and as rectangles of their own.
fn fences() -> [Scene; 2] {
    let height = [-1.0, 1.0];
    let holes = shape(rectangle([-2.0, 2.0], height, -4.0), 1);
    let column = |i: u32| {
        let left = -2.0 + f64::from(i);
        shape(rectangle([left, left + 0.5], height, -4.0), 2)
    };
    let albedo = [0.5, 0.3, 0.7];
    let materials = || {
        let of_holes = columns(true, 4.0);
        let plain = Material::default();
        vec![
            plain.clone(),
            Material { albedo, ..of_holes },
            Material { albedo, ..plain },
        ]
    };
    [
        before_a_wall(materials(), vec![holes]),
        before_a_wall(materials(), (0..4).map(column).collect()),
    ]
}

/// Pixels with another colour.
fn changed(left: &Frame, right: &Frame) -> usize {
    let pairs = left.color.iter().zip(&right.color);
    pairs.filter(|(left, right)| left != right).count()
}

#[test]
fn holes_are_as_if_nothing_were_there() {
    let [holes, columns] = fences();
    let [through, solid] = [&holes, &columns].map(on_cpu);
    // The wall and the columns are plain, so a colour tells which is seen, and whether it is in
    // the shadow. No ray goes so near an edge that a rounding decides.
    assert_eq!(changed(&through, &solid), 0);
    let colors = |frame: &Frame| {
        let mut colors: Vec<_> = frame.color.iter().map(|c| c.map(f32::to_bits)).collect();
        colors.sort_unstable();
        colors.dedup();
        colors.len()
    };
    assert_eq!(colors(&through), 3, "columns, and the wall, lit and not");
    assert_eq!(through.normal, solid.normal);
    // A ray begins anew behind a hole, off the shape by this part of its reach: the corners
    // are 7 from the camera.
    let most = 2.0 * 7.0 * OFFSET;
    for (through, solid) in through.depth.iter().zip(&solid.depth) {
        assert!((through - solid).abs() <= most, "{through} and {solid}");
    }
    // The controls: without holes, and without the fence.
    let mut closed = holes.clone();
    closed.materials[1].cutout = false;
    assert!(changed(&on_cpu(&closed), &solid) > 500);
    let mut open = holes;
    open.shapes.remove(0);
    assert!(changed(&on_cpu(&open), &solid) > 500);
}

/// Sheets that are nothing but holes.
fn sheets(count: u32) -> Scene {
    let mut nothing = columns(true, 1.0);
    if let Some(Texture {
        pattern: Pattern::Image(image),
        ..
    }) = &mut nothing.texture
    {
        Arc::make_mut(image).texels.fill([1.0, 1.0, 1.0, 0.0]);
    }
    let sheet = |i: u32| {
        let depth = -2.0 - f64::from(i) / 64.0;
        shape(rectangle([-9.0, 9.0], [-9.0, 9.0], depth), 1)
    };
    let sheets = (0..count).map(sheet).collect();
    before_a_wall(vec![Material::default(), nothing], sheets).with_size(8, 6)
}

#[test]
fn a_ray_goes_through_so_many_holes() {
    let bare = on_cpu(&sheets(0));
    let most = on_cpu(&sheets(MOST_HOLES));
    assert_eq!(changed(&bare, &most), 0);
    assert_eq!(bare.normal, most.normal);
    // The last sheet is seen as if it had no hole.
    let more = on_cpu(&sheets(MOST_HOLES + 1));
    let z = more.position[4 + 3 * 8][2];
    assert!((z + 3.0).abs() < 1e-3, "{z}");
    assert!((bare.position[4 + 3 * 8][2] + 6.0).abs() < 1e-3);
}

/// A light before something solid, behind sheets of holes: the way ends at the light.
#[test]
fn what_is_behind_a_light_keeps_nothing_off() {
    let pixel = |count, depth: f64| {
        let mut scene = sheets(count);
        scene.lights = vec![Light::Point {
            position: DVec3::new(0.4, 0.3, -1.0),
            color: [9.0; 3],
            falloff: Falloff::InverseSquare,
            shadow: true,
        }];
        let quad = rectangle([0.2, 0.6], [0.2, 0.6], depth);
        scene.shapes.push(shape(quad, 0));
        on_cpu(&scene).color[2 + 4 * 8]
    };
    let bare = pixel(0, -0.9);
    let through = pixel(3, -0.9);
    // Behind a hole the ray begins anew, aside by this part of the reach of the sheet, whose
    // corners are 20 away; light that falls with the square of a way of 5, and by a cosine,
    // changes by three parts of that.
    let most = 3.0 * (20.0 * OFFSET) * 3.0 / 5.0 * bare[0];
    for (through, bare) in through.into_iter().zip(bare) {
        assert!((through - bare).abs() <= most, "{through} and {bare}");
    }
    // The control: before the light it keeps all of it off.
    let shadowed = pixel(3, -1.1);
    assert_eq!(shadowed, pixel(0, -1.1));
    assert!(bare[0] - shadowed[0] > most);
}

/// What comes through fog falls with the whole way, not with that from the last hole.
#[test]
fn fog_is_as_thick_before_a_hole_as_behind() {
    const SAMPLES: u32 = 4096;
    let seen = |count| {
        let mut scene = sheets(count).with_size(1, 1);
        scene.camera.fov_degrees = 0.01;
        scene.lights.clear();
        scene.ambient = [0.0; 3];
        scene.materials[0].emission = [1.0; 3];
        scene.materials[0].albedo = [0.0; 3];
        scene.fog = Some(Fog {
            density: 0.2,
            albedo: [0.0; 3],
        });
        scene.integrator.samples = SAMPLES;
        f64::from(on_cpu(&scene).color[0][0])
    };
    // One way of each 1 / SAMPLES is drawn; and a way of 6 is off by some roundings.
    let most = 1.0 / f64::from(SAMPLES) + 1e-5;
    let expected = (-0.2f64 * 6.0).exp();
    for count in [0, 1, 5] {
        assert!(
            (seen(count) - expected).abs() <= most,
            "{count}: {}",
            seen(count)
        );
    }
    let from_the_hole = (-0.2f64 * 4.0).exp();
    assert!((seen(1) - from_the_hole).abs() > most, "the control");
}

#[test]
fn cutouts_have_the_same_bits_on_both_sides() {
    let [mut scene, _] = fences();
    let ball = Geometry::Sphere {
        center: DVec3::new(0.3, -0.2, -3.0),
        radius: 0.7,
    };
    let floor = Geometry::Plane {
        point: DVec3::new(0.0, -1.2, 0.0),
        normal: DVec3::Y,
    };
    scene.shapes.extend([shape(ball, 1), shape(floor, 1)]);
    scene.occlusion = 1.0;
    scene.integrator.samples = 4;
    scene.integrator.bounces = 2;
    let cpu = on_cpu(&scene);
    assert_same_bits(&cpu, &on_gpu(&scene));
    scene.materials[1].cutout = false;
    assert!(changed(&cpu, &on_cpu(&scene)) > 500, "the control");
}

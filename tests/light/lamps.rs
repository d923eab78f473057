//! Lamps that have a size, against closed forms.

use std::f64::consts::PI;

use glam::{DMat3, DVec3};
use rayproof::flat::Flat;
use rayproof::flatten::flatten_with_ids;
use rayproof::gpu::device::Gpu;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::hit::{Surface, no_hit};
use rayproof::kernel::lamps::weight_of_lamp;
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::trace::{find_hit, surface_of};
use rayproof::kernel::vector::Vec3;
use rayproof::layout::NO_HIT;
use rayproof::random::Numbers;
use rayproof::render::Backend;
use rayproof::scene::{AreaForm, Falloff, Light};

use crate::sampled::{Mean, arriving, path, seen, single, surface};
use crate::scenes::{disk, lamp, picture, rectangle, room, sphere, under};

const SAMPLES: u32 = 1 << 14;

/// Roundings of a sample's light: some forty operations, none of which cancels.
const ROUNDINGS: f64 = 64.0;

#[test]
fn both_sides_have_the_same_bits() {
    for (samples, bounces) in [(1, 0), (8, 4)] {
        let scene = room(96, samples, bounces);
        let gpu = Gpu::open(None).expect("a Vulkan driver, such as mesa-vulkan-drivers");
        let gpu = picture(&scene, &Backend::Gpu(Box::new(gpu)));
        let cpu = picture(&scene, &Backend::Cpu(None));
        assert!(gpu.has_bits_of(&cpu), "{samples} {bounces}");
        // The control: another seed.
        let mut other = scene.clone();
        other.integrator.seed = 1;
        assert!(!gpu.has_bits_of(&picture(&other, &Backend::Cpu(None))));
    }
}

/// L (r/d)^2 cos of what is wholly above the horizon, however small or far it is.
#[test]
fn a_sphere_lights_by_the_square_of_its_sine() {
    for (distance, radius) in [
        (2.0, 1.0),
        (1.1, 1.0),
        (3.0, 1e-3),
        (1e6, 10.0),
        (1e9, 1e-3),
    ] {
        let axis = DVec3::new(0.3, 0.9, -0.2).normalize();
        let flat = under(lamp(sphere(axis * distance, radius), [2.0; 3]));
        let part: f64 = radius / distance;
        // As far as it stays above the horizon.
        for lean in [0.0, 0.9 * part.acos()] {
            let side = axis.any_orthonormal_vector();
            let normal = axis * f64::cos(lean) + side * f64::sin(lean);
            let found = seen(&flat, &surface(DVec3::ZERO, normal), SAMPLES);
            let exact = 2.0 * part * part * f64::cos(lean);
            assert!(found.fits(exact, ROUNDINGS), "{found:?}, {exact}");
            // The control: a sphere larger by a part in 20.
            assert!(!found.fits(exact * 1.05 * 1.05, ROUNDINGS));
        }
    }
}

#[test]
fn a_disk_lights_what_lies_on_its_axis() {
    for (height, radius) in [(1.0, 1.0), (3.0, 0.5), (0.5, 2.0)] {
        let center = DVec3::new(0.2, 0.4, -1.0);
        let normal = DVec3::new(0.1, -1.0, 0.5).normalize();
        let flat = under(lamp(disk(center, normal, radius), [1.0; 3]));
        let place = surface(center + normal * height, -normal);
        let found = seen(&flat, &place, SAMPLES);
        let exact = radius * radius / (radius * radius + height * height);
        assert!(found.fits(exact, ROUNDINGS), "{found:?}, {exact}");
        assert!(!found.fits(exact * 2.0, ROUNDINGS));
        // Behind it there is no light.
        let behind = surface(center - normal * height, normal);
        assert_eq!(seen(&flat, &behind, 64).value, 0.0);
    }
}

/// Lambert, "Photometria", 1760: a polygon, by the angles of its edges.
fn of_polygon(corners: &[DVec3], normal: DVec3) -> f64 {
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let sum: f64 = edges
        .map(|(a, b)| {
            let across = a.cross(*b);
            let angle = across.length().atan2(a.dot(*b));
            angle * across.normalize().dot(normal)
        })
        .sum();
    sum.abs() / (2.0 * PI)
}

#[test]
fn a_rectangle_lights_by_its_form_factor() {
    for tilt in [DMat3::IDENTITY, DMat3::from_rotation_x(0.4)] {
        let center = DVec3::new(0.3, 1.5, -0.2);
        let right = tilt * DVec3::new(0.8, 0.0, 0.1);
        let up = tilt * DVec3::new(0.3, 0.0, 1.1);
        let flat = under(lamp(rectangle(center, right, up), [1.0; 3]));
        for normal in [DVec3::Y, DVec3::new(0.4, 1.0, 0.3).normalize()] {
            let place = DVec3::new(0.1, 0.2, 0.0);
            // right x up points down.
            let found = seen(&flat, &surface(place, normal), SAMPLES);
            let halves = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            let corners = halves.map(|(x, y)| center + (right * x + up * y) / 2.0 - place);
            let exact = of_polygon(&corners, normal);
            assert!(found.fits(exact, ROUNDINGS), "{found:?}, {exact}");
            assert!(!found.fits(exact * 1.03, ROUNDINGS));
        }
    }
}

#[test]
fn light_weakens_with_the_square_of_the_distance() {
    let ratio = |light: &dyn Fn(f64) -> Light| {
        let of = |distance| {
            let flat = under(light(distance));
            seen(&flat, &surface(DVec3::ZERO, DVec3::Y), SAMPLES).value
        };
        of(10.0) / of(20.0)
    };
    let point = |falloff| {
        move |distance| Light::Point {
            position: DVec3::Y * distance,
            color: [1.0; 3],
            falloff,
            shadow: true,
        }
    };
    let small = |distance| lamp(sphere(DVec3::Y * distance, 0.01), [1.0; 3]);
    let off = |ratio: f64| (ratio / 4.0 - 1.0).abs();
    let most = ROUNDINGS / f64::from(1 << 24);
    assert!(off(ratio(&point(Falloff::InverseSquare))) < most);
    // Cosines within the lamp differ by a part in 2 million.
    assert!(off(ratio(&small)) < most + 0.5 * 1e-6);
    assert!(off(ratio(&point(Falloff::None))) > 0.5, "the control");
}

fn forms() -> [AreaForm; 3] {
    [
        sphere(DVec3::new(0.4, 2.0, -0.3), 0.7),
        disk(DVec3::new(-0.5, 1.2, 0.3), DVec3::new(0.3, -1.0, 0.1), 0.8),
        rectangle(
            DVec3::new(0.2, 0.9, 0.4),
            DVec3::X,
            DVec3::new(0.0, 0.3, 0.9),
        ),
    ]
}

/// How a path with this density finds the lamp; none where it meets nothing.
fn found(flat: &Flat<f32>, place: DVec3, direction: DVec3, density: f32) -> Option<f64> {
    let ray = Ray {
        origin: single(place),
        direction: single(direction),
    };
    let mut hit = no_hit();
    find_hit(flat, probe_of(ray), &mut hit);
    if hit.id == NO_HIT {
        return None;
    }
    let surface: Surface = surface_of(flat, ray, hit);
    let material = flat.material_indices[hit.id as usize];
    let mut path = path(flat, 0);
    (path.ray, path.density) = (ray, density);
    Some(weight_of_lamp(flat, &path, hit, &surface, material).into())
}

/// The densities of all directions make 1: those that a path finds, by its weight.
#[test]
fn densities_that_are_found_are_those_of_all_directions() {
    for form in forms() {
        let flat = under(lamp(form, [1.0; 3]));
        let mut random = Numbers(9);
        let place = DVec3::new(0.1, 0.05, 0.0);
        let density_of = |direction| match found(&flat, place, direction, 1.0) {
            // The back is found with no density, and its light counts nothing.
            None | Some(0.0) => 0.0,
            Some(weight) => 1.0 / weight - 1.0,
        };
        let samples = (0..1 << 16).map(|_| 4.0 * PI * density_of(random.direction()));
        let all = Mean::of(samples);
        assert!(all.fits(1.0, ROUNDINGS), "{form:?}: {all:?}");
        assert!(!all.fits(1.25, ROUNDINGS), "the control: {all:?}");
    }
}

/// A direction is found with the density with which it is drawn: it weighs half.
#[test]
fn what_is_drawn_is_found_with_the_same_density() {
    let place = DVec3::new(0.1, 0.05, 0.0);
    for form in forms() {
        let flat = under(lamp(form, [1.0; 3]));
        let at = surface(place, DVec3::Y);
        let mut missed = 0;
        for number in 0..2000 {
            let (arriving, _) = arriving(&flat, &at, number);
            let towards: [f32; 3] = arriving.towards.into();
            let towards = DVec3::from_array(towards.map(f64::from));
            match found(&flat, place, towards, arriving.density) {
                // Along the edge roundings decide.
                None => missed += 1,
                // Angles of 2 roundings of the distance, at cosines of 1/10 and more.
                Some(weight) => assert!((weight - 0.5).abs() < 1e-5, "{form:?}: {weight}"),
            }
        }
        assert!(missed <= 2, "{missed}");
    }
}

/// From within a sphere, and from behind, no light is found either.
#[test]
fn backs_are_dark() {
    for (form, place) in [
        (sphere(DVec3::ZERO, 2.0), DVec3::X),
        (disk(DVec3::X, DVec3::X, 1.0), DVec3::ZERO),
        (rectangle(DVec3::X, DVec3::Y, DVec3::Z), DVec3::ZERO),
    ] {
        let flat = under(lamp(form, [1.0; 3]));
        let at = surface(place, DVec3::X);
        assert_eq!(arriving(&flat, &at, 3).0.density, 0.0);
        assert_eq!(found(&flat, place, DVec3::X, 0.0), Some(0.0));
        assert_eq!(found(&flat, place, DVec3::X, 2.0), Some(0.0));
        // The control: from the other side.
        let front = found(&flat, place + DVec3::X * 8.0, DVec3::NEG_X, 0.0);
        assert_eq!(front, Some(1.0));
    }
}

/// Lamps are numbered behind the shapes of their kind, and each is as large as it lights.
#[test]
fn lamps_are_shapes_behind_those_of_the_scene() {
    let mut scene = room(16, 1, 0);
    scene
        .lights
        .push(lamp(sphere(DVec3::splat(3.0), 0.1), [1.0; 3]));
    let (flat, ids) = flatten_with_ids::<f64>(&scene);
    // A sphere of the scene and two, three planes, a disk, a triangle and two.
    assert_eq!(ids[..5], [3..4, 4..5, 5..6, 0..1, 7..8]);
    assert_eq!(ids[5..], [1..2, 6..7, 8..10, 2..3]);
    let materials: Vec<u32> = ids[5..]
        .iter()
        .map(|ids| flat.material_indices[ids.start as usize])
        .collect();
    assert_eq!(materials, [3, 4, 5, 6]);
    for (lamp, record) in flat.lamps.iter().enumerate() {
        let finish = flat.finishes[materials[lamp] as usize];
        assert_eq!(finish.lamp, lamp as u32);
        assert_eq!(finish.emission, record.radiance);
        assert_eq!(flat.materials[materials[lamp] as usize].albedo, [0.0; 3]);
    }
    let corners = flat.triangles[1..].iter().map(|corners| {
        let [a, b, c] = corners
            .vertices
            .map(|row| DVec3::from(flat.vertices[row as usize]));
        (b - a).cross(c - a)
    });
    let area: DVec3 = corners.sum::<DVec3>() / 2.0;
    let record = &flat.lamps[2];
    let normal = Vec3::from(record.normal);
    let front = area.dot(DVec3::new(
        normal.x.into(),
        normal.y.into(),
        normal.z.into(),
    ));
    assert!((front - f64::from(record.area)).abs() < 1e-6 * front);
}

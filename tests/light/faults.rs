//! Samples that are no numbers: counted, told of, and left out.

use glam::DVec3;
use rayproof::render::Backend;
use rayproof::scene::{Background, Falloff, Geometry, Light};
use rayproof::{Accuracy, Rendering, Scene, Unwatched};

use crate::common::{assert_same_bits, gpu};
use crate::scenes::{matt, shape};

/// As bright as a light may be in a scene, by a power of 2.
const BRIGHT: f64 = (1u64 << 49) as f64;

/// The same, so much darker that nothing is too large.
const DIM: f64 = 1.0 / (1u64 << 41) as f64;

/// Before a wall a disk of so large a radius, and as near, with a light point right above it:
/// its light may be more than an f32 can hold. Then red is infinite, and green, of which nothing
/// is left, no number.
fn scene(radius: f64, color: f64) -> Scene {
    let disk = Geometry::Disk {
        center: DVec3::new(0.0, -1.0, -3.0) * radius,
        normal: DVec3::Y,
        radius,
    };
    let wall = Geometry::Plane {
        point: DVec3::NEG_Z * 3.0,
        normal: DVec3::Z,
    };
    let mut scene = Scene {
        background: Background::plain([0.0; 3]),
        materials: vec![matt([1.0, 0.0, 0.5])],
        shapes: vec![shape(disk, 0), shape(wall, 0)],
        lights: vec![Light::Point {
            position: DVec3::new(0.3, -0.98, -3.0) * radius,
            color: [color; 3],
            falloff: Falloff::InverseSquare,
            shadow: true,
        }],
        ..Scene::default()
    }
    .with_size(40, 30);
    scene.integrator.samples = 16;
    scene
}

fn made(scene: &Scene, backend: &Backend) -> Rendering {
    rayproof::render(scene, backend, Accuracy::Robust, &Unwatched).unwrap()
}

#[test]
fn faults_are_counted_and_do_not_spread() {
    let cpu = Backend::Cpu(None);
    let graphics = Backend::Gpu(Box::new(gpu()));
    // The luminance's square is too large; so is the light itself.
    for radius in [2f64.powi(-4), 2f64.powi(-40)] {
        let [here, there] = [&cpu, &graphics].map(|backend| made(&scene(radius, BRIGHT), backend));
        assert_same_bits(&here.frame, &there.frame);
        let (faults, first) = (here.stats.faults, here.stats.first_fault);
        assert_eq!(
            (faults, first),
            (there.stats.faults, there.stats.first_fault)
        );
        println!("{radius}: {faults} {first:?}");
        assert!(faults > 0);
        // The control: the same light, but for a power of 2.
        let dim = made(&scene(radius, DIM), &cpu);
        assert_eq!((dim.stats.faults, dim.stats.first_fault), (0, None));
        let bright = dim.frame.color.iter().map(|color| color.map(f64::from));
        let bright = bright.map(|color| color.map(|channel| (channel * (BRIGHT / DIM)) as f32));
        let mut others = Vec::new();
        for (index, (found, expected)) in here.frame.color.iter().zip(bright).enumerate() {
            assert!(found.iter().all(|channel| channel.is_finite()), "{found:?}");
            if *found != expected {
                others.push([index as u32 % 40, index as u32 / 40]);
            }
        }
        // A pixel that lacks some samples is another one, and it is the only one.
        assert_eq!(others.first().copied(), first);
        assert!(others.len() as u64 <= faults, "{faults}: {others:?}");
        assert!(others.len() * 16 >= faults as usize, "{faults}: {others:?}");
    }
}

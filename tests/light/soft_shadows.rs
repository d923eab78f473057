//! Shadows of lamps that have a size.

use glam::DVec3;
use rayproof::flatten::flatten;
use rayproof::random::Numbers;
use rayproof::scene::{Geometry, Scene};

use crate::sampled::{Mean, arriving, shadowed, surface};
use crate::scenes::{disk, lamp, matt, rectangle, shape, sphere, under};

/// The ray that looks for what is in between ends before the lamp itself, from grazing
/// angles and over large distances too.
#[test]
fn a_lamp_does_not_shadow_itself() {
    let (mut controls, mut lit) = (0, 0);
    let mut random = Numbers(4);
    for round in 0..3000 {
        let size = 10f64.powf(random.between(-3.0, 3.0));
        let center = random.direction() * size * 10f64.powf(random.between(0.5, 3.0));
        let form = match round % 3 {
            0 => sphere(center, size),
            1 => disk(center, random.direction(), size),
            _ => {
                let right = random.direction();
                rectangle(center, right * size, right.cross(random.direction()) * size)
            }
        };
        let flat = under(lamp(form, [1.0; 3]));
        let place = center + random.direction() * size * 10f64.powf(random.between(0.1, 3.0));
        let at = surface(place, center - place);
        for number in 0..8 {
            let (mut arriving, _) = arriving(&flat, &at, number);
            if arriving.density > 0.0 {
                lit += 1;
                assert!(!shadowed(&flat, &at, &arriving), "{form:?} from {place}");
                // The control: all the way to the point.
                arriving.goal = at.position + arriving.towards;
                controls += u32::from(shadowed(&flat, &at, &arriving));
            }
        }
    }
    assert!(lit > 6000, "{lit}");
    assert!(controls > lit / 10, "{controls} of {lit}");
}

/// A straight edge under a lamp: where all of it is seen, where none, and as much as there
/// is in between.
#[test]
fn a_penumbra_lies_where_it_should() {
    let (half, height, edge) = (0.5, 3.0, 1.0);
    let corner = |x: f64, z: f64| DVec3::new(x, edge, z);
    let vertices = [corner(0.0, -100.0), corner(0.0, 100.0), corner(-200.0, 0.0)];
    let form = rectangle(DVec3::Y * height, DVec3::X * 2.0 * half, DVec3::Z);
    let mut scene = Scene {
        lights: vec![lamp(form, [1.0; 3])],
        shapes: vec![shape(Geometry::Triangle { vertices }, 0)],
        materials: vec![matt([0.5; 3])],
        ..Scene::default()
    };
    scene.camera.eye = DVec3::new(0.0, 0.5, 4.0);
    let flat = flatten::<f32>(&scene);
    // By similar triangles.
    let outer = half * edge / (height - edge);
    let lit = |x: f64| {
        let at = surface(DVec3::X * x - scene.camera.eye, DVec3::Y);
        let samples = (0..4096).map(|number| {
            let (arriving, _) = arriving(&flat, &at, number);
            assert!(arriving.density > 0.0);
            f64::from(u8::from(!shadowed(&flat, &at, &arriving)))
        });
        Mean::of(samples)
    };
    assert_eq!(lit(outer * 1.001).value, 1.0);
    assert_eq!(lit(-outer * 1.001).value, 0.0);
    for part in [-0.9, -0.5, 0.0, 0.3, 0.95] {
        let found = lit(outer * part);
        assert!(found.fits((1.0 + part) / 2.0, 0.0), "{part}: {found:?}");
        assert!(!found.fits((1.2 + part) / 2.0, 0.0));
    }
}

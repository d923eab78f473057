//! The ways to find lamps and skies agree, and weighing them is worth it.

use glam::DVec3;
use rayproof::flatten::flatten;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::frame::cosine_direction;
use rayproof::kernel::hit::no_hit;
use rayproof::kernel::indirect::{even_density, even_weight};
use rayproof::kernel::integrator::Look;
use rayproof::kernel::lamps::weight_of_lamp;
use rayproof::kernel::numbers::number_pair;
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::sky::seen_sky;
use rayproof::kernel::trace::{find_hit, surface_of};
use rayproof::kernel::vector::dot_product;
use rayproof::layout::NO_HIT;
use rayproof::scene::{AreaForm, Scene, Strategy};

use crate::noisy::Noisy;
use crate::sampled::{Mean, arriving, path, shadowed, surface};
use crate::scenes::{lamp, ramp, room, sphere};

fn by(strategy: Strategy, samples: u32) -> Scene {
    let mut scene = room(48, samples, 3);
    scene.integrator.strategy = strategy;
    scene
}

#[test]
fn all_ways_find_the_same_light() {
    let samples = 256;
    let [both, lights, surfaces] = [Strategy::Both, Strategy::Lights, Strategy::Surfaces]
        .map(|strategy| Noisy::of(&by(strategy, samples)));
    println!("{} {} {}", both.error, lights.error, surfaces.error);
    assert!(both.agrees(&lights));
    assert!(both.agrees(&surfaces));
    assert!(lights.agrees(&surfaces));
    assert!(both.error <= lights.error.max(surfaces.error));
    // The control: lamps that are brighter by a part in 10.
    let mut brighter = by(Strategy::Both, samples);
    for light in &mut brighter.lights {
        if let rayproof::scene::Light::Area { radiance, .. } = light {
            *radiance = radiance.map(|channel| channel * 1.1);
        }
    }
    assert!(!Noisy::of(&brighter).agrees(&lights));
}

/// What a white surface looks like, by light that is searched for and by light that is
/// found; weighted or, for the control, all of both.
fn by_both_ways(scene: &Scene, is_weighted: bool) -> Mean {
    let flat = flatten::<f32>(scene);
    let at = surface(DVec3::new(0.1, 0.0, 0.2), DVec3::Y);
    let look = Look {
        evenly: 1.0,
        ..Look::default()
    };
    let searched = Mean::of((0..1 << 15).map(|number| {
        let (arriving, cosine) = arriving(&flat, &at, number);
        if cosine == 0.0 || shadowed(&flat, &at, &arriving) {
            return 0.0;
        }
        let weight = match is_weighted {
            true => even_weight(&flat, &look, &arriving, cosine as f32),
            false => 1.0,
        };
        f64::from(arriving.color.x / arriving.square * weight) * cosine
    }));
    let found = Mean::of((0..1 << 15).map(|number| {
        let mut path = path(&flat, number);
        let pair = number_pair(path.numbers, 1);
        let direction = cosine_direction(at.normal, pair);
        path.ray = Ray {
            origin: at.position,
            direction,
        };
        path.density = match is_weighted {
            true => even_density(dot_product(at.normal, direction)),
            false => 0.0,
        };
        let mut hit = no_hit();
        find_hit(&flat, probe_of(path.ray), &mut hit);
        if hit.id == NO_HIT {
            return seen_sky(&flat, &path).x.into();
        }
        let surface = surface_of(&flat, path.ray, hit);
        let material = flat.material_indices[hit.id as usize];
        let weight = weight_of_lamp(&flat, &path, hit, &surface, material);
        f64::from(flat.finishes[material as usize].emission[0] * weight)
    }));
    searched.plus(found)
}

/// Veach's balance heuristic, by closed forms.
#[test]
fn weights_make_a_whole() {
    let part: f64 = 0.4;
    let distance = DVec3::new(0.4, 1.5, 0.0) - DVec3::new(0.1, 0.0, 0.2);
    let of_sphere = part * part / distance.length_squared() * distance.normalize().y;
    let disk = AreaForm::Disk {
        center: DVec3::new(0.1, 0.7, 0.2),
        normal: DVec3::NEG_Y,
        radius: 0.8,
    };
    let of_disk = 0.64 / (0.64 + 0.49);
    let lit = |form| Scene {
        lights: vec![lamp(form, [1.0; 3])],
        ..Scene::default()
    };
    let sky = Scene {
        environment: Some(ramp([0.2; 3], [1.0; 3])),
        ..Scene::default()
    };
    // The mean height of directions by their cosine is 2/3.
    let of_sky = 0.2 + 0.8 * (0.5 + 0.5 * 2.0 / 3.0);
    for (scene, exact) in [
        (lit(sphere(DVec3::new(0.4, 1.5, 0.0), part)), of_sphere),
        (lit(disk), of_disk),
        (sky, of_sky),
    ] {
        let found = by_both_ways(&scene, true);
        assert!(found.fits(exact, 64.0), "{found:?}, {exact}");
        let twice = by_both_ways(&scene, false);
        assert!(!twice.fits(exact, 64.0), "the control: {twice:?}");
        assert!(twice.fits(2.0 * exact, 64.0), "{twice:?}, {exact}");
    }
}

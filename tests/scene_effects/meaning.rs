//! The `Scene` that comes out of a file.

use glam::DVec3;
use rayproof::Scene;
use rayproof::scene::{AreaForm, Light, Pattern, Sky, Strategy};

use crate::broken_files::{HEAD, parse};

fn scene(body: &str) -> Scene {
    let text = format!("{HEAD}{body}");
    parse(&text)
        .unwrap_or_else(|e| panic!("{:?}\n{text}", miette::Report::new(e)))
        .scene
}

#[test]
fn what_a_file_leaves_out_asks_for_nothing() {
    let plain = scene("[[sphere]]\nradius = 1\n");
    let default = Scene::default();
    assert_eq!(plain.integrator, default.integrator);
    assert_eq!(plain.environment, None);
    assert_eq!(plain.fog, None);
    assert_eq!(plain.occlusion, 0.0);
    assert_eq!(plain.camera.aperture, 0.0);
    assert_eq!(plain.camera.focus, None);
    assert_eq!(plain.camera.velocity, DVec3::ZERO);
    assert_eq!(plain.shapes[0].velocity, DVec3::ZERO);
}

#[test]
fn lights_cast_shadows_unless_they_are_told_not_to() {
    let lit = scene(
        "[[light]]\nkind = 'point'\nposition = [1, 2, 3]\n\
         [[light]]\nkind = 'directional'\ndirection = [1, 2, 3]\nshadow = false\n",
    );
    let shadows = lit.lights.iter().map(|light| match light {
        Light::Point { shadow, .. } | Light::Directional { shadow, .. } => *shadow,
        Light::Area { .. } => panic!("{light:?}"),
    });
    assert_eq!(shadows.collect::<Vec<_>>(), [true, false]);
}

#[test]
fn lamps_have_a_form_and_a_radiance() {
    let lit = scene(
        "[[light]]\nkind = 'sphere'\nposition = [1, 2, 3]\nradius = 4\ncolor = [1, 0.5, 0]\n\
         intensity = 8\n\
         [[light]]\nkind = 'disk'\nposition = [1, 2, 3]\nnormal = [0, -1, 0]\nradius = 2\n\
         [[light]]\nkind = 'rectangle'\ncorner = [1, 2, 3]\nright = [4, 0, 0]\nup = [0, 5, 0]\n",
    );
    let center = DVec3::new(1.0, 2.0, 3.0);
    let area = |form, radiance| Light::Area { form, radiance };
    let expected = [
        area(
            AreaForm::Sphere {
                center,
                radius: 4.0,
            },
            [8.0, 4.0, 0.0],
        ),
        area(
            AreaForm::Disk {
                center,
                normal: DVec3::NEG_Y,
                radius: 2.0,
            },
            [1.0; 3],
        ),
        area(
            AreaForm::Rectangle {
                corner: center,
                right: DVec3::X * 4.0,
                up: DVec3::Y * 5.0,
            },
            [1.0; 3],
        ),
    ];
    assert_eq!(lit.lights, expected);
}

#[test]
fn materials_say_how_they_answer_light() {
    let scene = scene(
        "[[material]]\nname = 'varnish'\nalbedo = [0.5, 0, 0]\nroughness = 0.3\n\
         [[material]]\nname = 'silver'\nmirror = 0.9\n\
         [[material]]\nname = 'gold'\nmirror = [1, 0.8, 0.3]\nroughness = 0.1\n\
         [[material]]\nname = 'glass'\nior = 1.5\nabsorption = [0.1, 0, 0.2]\n\
         [[material]]\nname = 'lava'\nemission = [20, 5, 0]\n\
         [[material]]\nname = 'tiles'\n\
         texture = { checker = [0.1, 0.2, 0.3], repeat = [4, 8], size = 0.5 }\n",
    );
    let named = |name: &str| {
        let found = scene.materials.iter().find(|m| m.name == name);
        found.unwrap_or_else(|| panic!("no {name}"))
    };
    let varnish = named("varnish");
    assert_eq!((varnish.mirror, varnish.roughness), ([0.04; 3], 0.3));
    let silver = named("silver");
    assert_eq!((silver.mirror, silver.roughness), ([0.9; 3], 0.0));
    assert_eq!(silver.albedo, [0.8; 3]);
    assert_eq!(named("gold").mirror, [1.0, 0.8, 0.3]);
    let glass = named("glass");
    assert_eq!((glass.ior, glass.absorption), (Some(1.5), [0.1, 0.0, 0.2]));
    assert_eq!(named("lava").emission, [20.0, 5.0, 0.0]);
    let tiles = named("tiles").texture.as_ref().expect("a texture");
    assert_eq!(tiles.pattern, Pattern::Checker([0.1, 0.2, 0.3]));
    assert_eq!((tiles.repeat, tiles.size), ([4.0, 8.0], 0.5));
}

#[test]
fn a_colour_drawn_by_lot_keeps_the_rest_of_its_material() {
    let scene = scene(
        "[[material]]\nname = 'lot'\nalbedo = { random = 1 }\nmirror = 0.2\n\
         [[sphere]]\nradius = 1\nmaterial = 'lot'\nvelocity = [0, 1, 0]\n\
         grid = { count = [2, 1, 1], step = [3, 0, 0] }\n",
    );
    let drawn: Vec<_> = scene
        .shapes
        .iter()
        .map(|s| &scene.materials[s.material])
        .collect();
    assert_ne!(drawn[0].albedo, drawn[1].albedo);
    assert!(drawn.iter().all(|m| m.mirror == [0.2; 3]));
    assert!(scene.shapes.iter().all(|s| s.velocity == DVec3::Y));
}

#[test]
fn surroundings_and_the_integrator_are_read() {
    let scene = scene(
        "[environment]\nfrom = [1, 1, 1]\nto = [0, 0, 4]\nslope = 2\nintensity = 3\nturn = 90\n\
         [integrator]\nsamples = 64\nbounces = 4\nreflections = 9\nseed = 7\n\
         strategy = 'surfaces'\n",
    );
    let environment = scene.environment.expect("an environment");
    let Sky::Gradient(ramp) = environment.sky else {
        panic!("{:?}", environment.sky);
    };
    assert_eq!(
        (ramp.to, ramp.offset, ramp.slope),
        ([0.0, 0.0, 4.0], 0.5, 2.0)
    );
    assert_eq!(
        (environment.intensity, environment.turn_degrees),
        (3.0, 90.0)
    );
    let integrator = scene.integrator;
    assert_eq!((integrator.samples, integrator.bounces), (64, 4));
    assert_eq!((integrator.reflections, integrator.seed), (9, 7));
    assert_eq!(integrator.strategy, Strategy::Surfaces);
}

//! An effect is on where something in the scene calls for it, and that is named.

use glam::DVec3;
use rayproof::bounds::{Bounds, bound};
use rayproof::effects::{EFFECTS, Effect, EffectSet, Part, without};
use rayproof::flatten::flatten;
use rayproof::scene::{Geometry, Scene, Shape};

use crate::scenes::{call_for, plain_scene};

fn is_on(effect: &Effect, scene: &Scene) -> bool {
    let mut flat = flatten::<f32>(scene);
    bound(&mut flat, Bounds::Tree);
    effect.is_called_for(&flat.counts())
}

/// The effects that scenes call for: not volumes, which the settings ask for.
fn of_scenes() -> impl Iterator<Item = &'static Effect> {
    let is_asked = |effect: &&Effect| !matches!(effect.part, Part::Bounds | Part::Screen);
    EFFECTS.iter().filter(is_asked)
}

#[test]
fn what_is_on_has_a_cause_and_what_is_off_has_none() {
    let folder = std::fs::read_dir("assets/scenes").unwrap();
    let mut scenes: Vec<(String, Scene)> = folder
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .map(|path| (path.display().to_string(), Scene::load(&path).unwrap()))
        .collect();
    for effect in EFFECTS.iter().filter(|effect| effect.part == Part::Path) {
        let mut scene = plain_scene();
        call_for(effect.name, &mut scene);
        scenes.push((format!("a scene with {}", effect.name), scene));
    }
    for (name, scene) in &scenes {
        for effect in of_scenes() {
            let cause = effect.cause(scene);
            assert_eq!(
                is_on(effect, scene),
                cause.is_some(),
                "{name}: {}",
                effect.name
            );
        }
    }
}

#[test]
fn a_cause_is_named_with_its_line() {
    let scene = Scene::load("assets/scenes/seed-spheres.toml").unwrap();
    let cause = |name: &str| {
        let effect = EFFECTS.iter().find(|effect| effect.name == name).unwrap();
        effect.cause(&scene).unwrap().to_string()
    };
    assert_eq!(cause("directional lights"), "light 1, line 24");
    assert_eq!(cause("spheres"), "sphere 1, line 39, and 71 more");
}

#[test]
fn shapes_are_counted_among_those_of_their_kind() {
    let mut scene = Scene::load("assets/scenes/shapes.toml").unwrap();
    let cause = |scene: &Scene, name: &str| {
        let effect = EFFECTS.iter().find(|effect| effect.name == name).unwrap();
        effect.cause(scene).unwrap().what
    };
    assert_eq!(cause(&scene, "planes"), "plane 1");
    assert_eq!(cause(&scene, "disks"), "disk 1");
    assert_eq!(cause(&scene, "triangles"), "triangle 1");
    let is_sphere = |shape: &&mut Shape| matches!(shape.geometry, Geometry::Sphere { .. });
    let mut spheres = scene.shapes.iter_mut().filter(is_sphere);
    spheres.nth(1).unwrap().velocity = DVec3::X;
    assert_eq!(cause(&scene, "motion blur"), "sphere 2");
}

#[test]
fn an_effect_can_be_taken_out_of_a_scene() {
    for effect in of_scenes().filter(|effect| effect.part == Part::Path) {
        let mut scene = plain_scene();
        call_for(effect.name, &mut scene);
        assert!(is_on(effect, &scene), "{}", effect.name);
        let left = without(&scene, effect.name).unwrap();
        assert!(!is_on(effect, &left), "{}", effect.name);
        left.validate().unwrap();
    }
    for (name, reason) in [("tree", "--bounds"), ("spheres", "the scene's shapes")] {
        let error = without(&plain_scene(), name).unwrap_err().to_string();
        assert!(error.contains(reason), "{error}");
    }
    let error = without(&plain_scene(), "magic").unwrap_err().to_string();
    assert!(error.contains("anti-aliasing"), "{error}");
}

#[test]
fn volumes_cannot_be_forced() {
    let error = EffectSet::of(["tree"]).unwrap_err().to_string();
    assert!(error.contains("--bounds"), "{error}");
    assert!(EffectSet::of(["fog", "magic"]).is_err());
}

//! What a scene does not call for changes no bit of its picture when it is in the shader.

use rayproof::effects::{EFFECTS, EffectSet};
use rayproof::gpu::device::Gpu;
use rayproof::render::{Accuracy, Backend, Settings, render};
use rayproof::scene::Scene;
use rayproof::watch::Unwatched;

use crate::scenes::{call_for, plain_scene};

fn picture(scene: &Scene, gpu: &Backend, forced: EffectSet) -> rayproof::frame::Frame {
    let settings = Settings {
        forced,
        ..Settings::from(Accuracy::Robust)
    };
    render(scene, gpu, settings, &Unwatched).unwrap().frame
}

fn check(scene: &Scene, gpu: &Backend, what: &str) {
    let pruned = picture(scene, gpu, EffectSet::NONE);
    let full = picture(scene, gpu, EffectSet::all());
    assert!(pruned.has_bits_of(&full), "{what}: with all effects");
}

/// Scenes that call for one ray a pixel, and for some of the paths' effects.
#[test]
fn all_effects_change_no_bit() {
    let gpu = Backend::Gpu(Box::new(Gpu::open(None).unwrap()));
    for name in ["seed-spheres", "seed-models", "shapes", "knot"] {
        let scene = Scene::load(format!("assets/scenes/{name}.toml")).unwrap();
        check(&scene.with_size(96, 72), &gpu, name);
    }
    let mut scene = plain_scene();
    check(&scene, &gpu, "the plain scene");
    for name in [
        "hard shadows",
        "ambient occlusion",
        "anti-aliasing",
        "indirect light",
    ] {
        call_for(name, &mut scene);
        check(&scene, &gpu, name);
    }
}

/// Each effect alone, so that two that are wrong do not hide each other.
#[test]
fn each_effect_changes_no_bit() {
    let gpu = Backend::Gpu(Box::new(Gpu::open(None).unwrap()));
    let scene = plain_scene();
    let pruned = picture(&scene, &gpu, EffectSet::NONE);
    for effect in EFFECTS.iter().filter(|effect| effect.may_be_forced()) {
        let forced = picture(&scene, &gpu, EffectSet::NONE.with(effect));
        assert!(pruned.has_bits_of(&forced), "{}", effect.name);
    }
    // The control: a scene that calls for an effect is another picture.
    let mut shadowed = plain_scene();
    call_for("hard shadows", &mut shadowed);
    let other = picture(&shadowed, &gpu, EffectSet::NONE);
    assert!(!pruned.has_bits_of(&other));
}

//! The gallery: each scene loads without a warning, calls for what its name promises, and
//! looks the same on the GPU as on the CPU.

mod common;

use std::path::Path;

use common::{assert_same_bits, gpu};
use rayproof::effects::EFFECTS;
use rayproof::render::Settings;
use rayproof::scene::parse::load;
use rayproof::scene::policy::Policy;
use rayproof::{Accuracy, Backend, Frame, Scene, Unwatched, render};

/// The scenes, and the effects that each is there to show.
const GALLERY: [(&str, &[&str]); 7] = [
    ("cornell", &["soft shadows", "indirect light"]),
    (
        "glass-and-mirrors",
        &[
            "refraction",
            "mirrors",
            "glossy reflection",
            "textures",
            "environment",
        ],
    ),
    ("teapots", &["depth of field", "smooth normals"]),
    ("soft-knot", &["soft shadows", "triangles"]),
    ("fog", &["fog", "soft shadows"]),
    ("sky-teapot", &["environment", "glossy reflection"]),
    ("motion", &["motion blur", "alpha cut-outs"]),
];

fn scene(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/scenes");
    let loaded = load(&folder.join(format!("{name}.toml")), &Policy::default())
        .unwrap_or_else(|error| panic!("{:?}", miette::Report::new(error)));
    assert_eq!(loaded.warnings, Vec::<String>::new(), "{name}");
    loaded.scene
}

#[test]
fn each_scene_calls_for_what_its_name_promises() {
    for (name, promised) in GALLERY {
        let scene = scene(name);
        for word in promised {
            let effect = EFFECTS.iter().find(|effect| effect.name == *word);
            let effect = effect.unwrap_or_else(|| panic!("no effect is named {word}"));
            assert!(effect.cause(&scene).is_some(), "{name}: {word}");
        }
        let paths = scene.integrator.samples > 1;
        assert!(paths, "{name} is a picture of one path a pixel");
    }
}

#[test]
fn each_scene_is_the_same_on_gpu_and_cpu() {
    let gpu = Backend::Gpu(Box::new(gpu()));
    for (name, _) in GALLERY {
        let mut scene = scene(name).with_size(48, 36);
        scene.integrator.samples = 2;
        let on = |backend: &Backend| -> Frame {
            let settings = Settings::from(Accuracy::Robust);
            render(&scene, backend, settings, &Unwatched).unwrap().frame
        };
        let frame = on(&gpu);
        assert_same_bits(&frame, &on(&Backend::Cpu(None)));
        let lit = frame.color.iter().filter(|color| color[0] > 0.0).count();
        assert!(2 * lit > frame.color.len(), "{name}: {lit} pixels are lit");
    }
}

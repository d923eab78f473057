//! The images of a scene: each loaded once, all within one limit, none too bright for a surface.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use rayproof::error::Error;
use rayproof::frame::{Frame, Layer, write_rgb8};
use rayproof::scene::parse::parse_str;
use rayproof::scene::policy::Policy;
use rayproof::scene::{Pattern, Scene, Sky, Texels};
use tempfile::TempDir;

/// An image of 2 x 2 texels of one grey.
fn write_exr(path: &Path, grey: f32) {
    let mut frame = Frame::new(2, 2).expect("four pixels");
    frame.color.fill([grey; 3]);
    frame.write_exr(path, &[Layer::Color]).expect("an image");
}

/// A folder with `wood.png`, `sky.exr` and `lamp.exr` of four texels each, the last of them
/// brighter than white, and with a mesh for each image, `NAME.obj`.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = |name: &str| folder.path().join(name);
    write_rgb8(&path("wood.png"), 2, 2, &[90; 12]).expect("an image");
    write_exr(&path("sky.exr"), 1.0);
    write_exr(&path("lamp.exr"), 9.0);
    for name in ["wood.png", "sky.exr", "lamp.exr"] {
        let obj = format!(
            "mtllib {name}.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n"
        );
        fs::write(path(&format!("{name}.obj")), obj).expect("a file");
        let mtl = format!("newmtl m\nmap_Kd {name}\n");
        fs::write(path(&format!("{name}.mtl")), mtl).expect("a file");
    }
    folder
}

/// A scene with these texels at most.
fn load(folder: &TempDir, text: &str, max_texels: u64) -> Result<Scene, Error> {
    let camera = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n";
    let policy = Policy {
        max_texels,
        ..Policy::default()
    };
    let text = format!("{camera}{text}");
    parse_str(&text, "scene.toml", folder.path(), &policy).map(|loaded| loaded.scene)
}

/// What is wrong, in one text.
fn refusal(folder: &TempDir, text: &str, max_texels: u64) -> String {
    match load(folder, text, max_texels).expect_err("a fault") {
        Error::Scene(faults) => {
            let told = faults.faults.iter().map(|fault| fault.message.as_str());
            told.collect::<Vec<_>>().join("\n")
        }
        other => panic!("{other}"),
    }
}

fn images(scene: &Scene) -> Vec<Arc<Texels>> {
    let textures = scene.materials.iter().filter_map(|m| m.texture.as_ref());
    let mut images: Vec<_> = textures
        .filter_map(|texture| match &texture.pattern {
            Pattern::Image(image) => Some(Arc::clone(image)),
            Pattern::Checker(_) => None,
        })
        .collect();
    if let Some(Sky::Image(image)) = scene.environment.as_ref().map(|around| &around.sky) {
        images.push(Arc::clone(image));
    }
    images
}

const SKY: &str = "[environment]\nfile = 'sky.exr'\n";
const WOOD: &str = "[[material]]\nname = 'wood'\ntexture = { file = 'wood.png' }\n";
const WOODEN_MESH: &str = "[[mesh]]\nfile = 'wood.png.obj'\n";
const SKY_MESH: &str = "[[mesh]]\nfile = 'sky.exr.obj'\n";

#[test]
fn materials_meshes_and_the_sky_share_images() {
    let folder = folder();
    let text = format!("{SKY}{WOOD}{WOODEN_MESH}{SKY_MESH}");
    // Two files of four texels.
    let scene = load(&folder, &text, 8).expect("a scene");
    let images = images(&scene);
    let [wood, of_mesh, of_other, sky] = images.as_slice() else {
        panic!("{} images", images.len());
    };
    assert!(Arc::ptr_eq(wood, of_mesh) && Arc::ptr_eq(of_other, sky));
    assert!(!Arc::ptr_eq(wood, sky));
}

#[test]
fn all_images_share_one_limit() {
    let folder = folder();
    let told = "2 x 2 texels beside 4 in other images are more than the 7 allowed";
    for text in [
        format!("{SKY}{WOOD}"),
        format!("{SKY}{WOODEN_MESH}"),
        format!("{WOOD}{SKY_MESH}"),
        format!("{WOODEN_MESH}{SKY_MESH}"),
    ] {
        assert!(load(&folder, &text, 8).is_ok(), "{text}");
        let refusal = refusal(&folder, &text, 7);
        assert!(refusal.contains(told), "{text}: {refusal}");
    }
}

#[test]
fn a_texture_is_no_brighter_than_white_wherever_it_is_named() {
    let folder = folder();
    let told = "lamp.exr: the image has colours up to 9, but a texture's end at 1";
    for (text, place) in [
        (WOOD.replace("wood.png", "lamp.exr"), ""),
        (
            WOODEN_MESH.replace("wood.png", "lamp.exr"),
            "lamp.exr.mtl:2: map_Kd: ",
        ),
    ] {
        let refusal = refusal(&folder, &text, 8);
        assert!(refusal.contains(told), "{text}: {refusal}");
        assert!(refusal.contains(place), "{text}: {refusal}");
    }
    // As a sky it may be.
    let sky = SKY.replace("sky.exr", "lamp.exr");
    assert!(load(&folder, &sky, 8).is_ok());
    // What the reader lets through, the rules for scenes in code do too.
    let white = load(&folder, SKY_MESH, 8).expect("a scene");
    white.validate().expect("a scene in order");
}

#[test]
fn each_that_names_a_bad_image_has_the_fault() {
    let folder = folder();
    fs::write(folder.path().join("wood.png"), "no image").expect("a file");
    let twice = WOOD.replace("'wood'", "'timber'");
    let refusal = refusal(&folder, &format!("{WOOD}{twice}{WOODEN_MESH}"), 8);
    assert_eq!(refusal.matches("wood.png: ").count(), 3, "{refusal}");
}

use glam::DVec3;

use super::tests::{said, starts, valid};
use super::*;
use crate::scene::{
    AreaForm, Background, Environment, Fog, Light, Material, Pattern, Rgb, Texture,
};

fn material(edit: impl FnOnce(&mut Material)) -> String {
    said(|s| edit(&mut s.materials[0]))
}

fn textured(texture: Texture) -> impl FnOnce(&mut Material) {
    |m| m.texture = Some(texture)
}

fn checker(rgb: Rgb) -> Texture {
    Texture {
        pattern: Pattern::Checker(rgb),
        repeat: [1.0; 2],
        size: 1.0,
    }
}

fn image(texels: Vec<[f32; 4]>) -> Arc<Texels> {
    Arc::new(Texels {
        name: "a.png".into(),
        width: 2,
        height: 1,
        texels,
    })
}

fn pictured(texels: Vec<[f32; 4]>) -> Texture {
    Texture {
        pattern: Pattern::Image(image(texels)),
        ..checker([0.0; 3])
    }
}

fn environment(sky: Sky, intensity: f64) -> Environment {
    Environment {
        sky,
        intensity,
        turn_degrees: 0.0,
    }
}

#[test]
fn materials_are_checked() {
    for (edit, message) in [
        (
            (|m| m.mirror[1] = 1.5) as fn(&mut Material),
            "`mirror` must lie",
        ),
        (|m| m.mirror[1] = f64::NAN, "`mirror` must be a finite"),
        (|m| m.roughness = -0.1, "`roughness` must lie"),
        (|m| m.ior = Some(0.5), "`ior` must be from 1 to 4"),
        (|m| m.ior = Some(f64::NAN), "`ior` must be from 1 to 4"),
        (|m| m.absorption[0] = 1.0, "`absorption` goes with `ior`"),
        (
            |m| m.absorption[0] = -1.0,
            "`absorption` must not be negative",
        ),
        (
            |m| m.emission[2] = f64::INFINITY,
            "`emission` must be a finite",
        ),
        (|m| m.cutout = true, "`alpha = \"cutout\"` goes with"),
        (
            |m| (m.ior, m.mirror) = (Some(1.5), [0.1; 3]),
            "`mirror` goes without `ior`",
        ),
        (
            |m| (m.ior, m.roughness) = (Some(1.5), 0.1),
            "`roughness` goes without `ior`",
        ),
        (
            |m| (m.ior, m.texture) = (Some(1.5), Some(checker([0.0; 3]))),
            "`texture` goes without `ior`",
        ),
        (
            |m| (m.cutout, m.texture) = (true, Some(checker([0.0; 3]))),
            "`alpha = \"cutout\"` goes with",
        ),
    ] {
        starts(material(edit), &format!("material 0 (grey): {message}"));
    }
    let mut glass = valid();
    glass.materials[0].ior = Some(1.5);
    glass.materials[0].absorption = [1.0; 3];
    glass.materials[0].emission = [1000.0; 3];
    glass.validate().expect("glass that glows");
}

#[test]
fn textures_and_images_are_checked() {
    let white = [1.0f32; 4];
    for (texture, message) in [
        (checker([0.0, 1.5, 0.0]), "`checker` must lie"),
        (
            Texture {
                repeat: [1.0, 0.0],
                ..checker([0.0; 3])
            },
            "`repeat` must be greater",
        ),
        (
            Texture {
                size: f64::NAN,
                ..checker([0.0; 3])
            },
            "`size` must be a finite",
        ),
        (
            pictured(vec![white]),
            "a.png: an image of 2 x 1 has 1 texels",
        ),
        (
            pictured(vec![white, [0.0, f32::NAN, 0.0, 1.0]]),
            "a.png: texel 1 is",
        ),
        (
            pictured(vec![white, [0.0, 0.0, 0.0, 2.0]]),
            "a.png: texel 1 is",
        ),
        (
            pictured(vec![white, [0.0, 3.0, 0.0, 1.0]]),
            "the image has colours up to 3",
        ),
    ] {
        starts(
            material(textured(texture)),
            &format!("material 0 (grey): {message}"),
        );
    }
    let mut cut = valid();
    cut.materials[0].texture = Some(pictured(vec![white, [0.0; 4]]));
    cut.materials[0].cutout = true;
    cut.validate().expect("an image with a hole");
}

#[test]
fn lamps_are_checked() {
    let area = |form| Light::Area {
        form,
        radiance: [1.0; 3],
    };
    let center = DVec3::ZERO;
    for (form, message) in [
        (
            AreaForm::Sphere {
                center,
                radius: -1.0,
            },
            "`radius`",
        ),
        (
            AreaForm::Sphere {
                center: DVec3::X * 1e15,
                radius: 1e15,
            },
            "the light reaches",
        ),
        (
            AreaForm::Disk {
                center,
                normal: DVec3::ZERO,
                radius: 1.0,
            },
            "`normal`",
        ),
        (
            AreaForm::Rectangle {
                corner: center,
                right: DVec3::ONE,
                up: DVec3::splat(-3.0),
            },
            "`right` [1, 1, 1] and `up` [-3, -3, -3] are parallel",
        ),
        (
            AreaForm::Rectangle {
                corner: center,
                right: DVec3::ZERO,
                up: DVec3::Y,
            },
            "`right` is [0, 0, 0], shorter",
        ),
    ] {
        starts(
            said(|s| s.lights.push(area(form))),
            &format!("light 1: {message}"),
        );
    }
    let negative = Light::Area {
        form: AreaForm::Sphere {
            center,
            radius: 1.0,
        },
        radiance: [-1.0; 3],
    };
    starts(said(|s| s.lights.push(negative)), "light 1: `radiance`");
}

#[test]
fn surroundings_are_checked() {
    let plain = |color| Sky::Gradient(Background::plain(color));
    for (around, message) in [
        (environment(plain([-1.0; 3]), 1.0), "`environment from`"),
        (environment(plain([1.0; 3]), -1.0), "`intensity`"),
        (
            environment(plain([2.0; 3]), 1e15),
            "`color times intensity`",
        ),
        (
            environment(Sky::Image(image(Vec::new())), 1.0),
            "a.png: an image",
        ),
    ] {
        let message = format!("environment: {message}");
        starts(said(|s| s.environment = Some(around)), &message);
    }
    let fog = |density, albedo| Some(Fog { density, albedo });
    starts(said(|s| s.fog = fog(0.0, [1.0; 3])), "scene: `density`");
    starts(said(|s| s.fog = fog(1.0, [1.1; 3])), "scene: `albedo`");
    starts(said(|s| s.occlusion = -1.0), "scene: `occlusion`");
    let mut bright = valid();
    bright.environment = Some(environment(
        Sky::Image(image(vec![[9e14, 0.0, 0.0, 1.0]; 2])),
        1.0,
    ));
    bright.validate().expect("the sun is bright");
}

#[test]
fn lenses_motion_and_numbers_of_paths_are_checked() {
    starts(said(|s| s.camera.aperture = -1.0), "scene: `aperture`");
    starts(said(|s| s.camera.focus = Some(0.0)), "scene: `focus`");
    starts(
        said(|s| s.camera.velocity.x = f64::NAN),
        "scene: `velocity`",
    );
    starts(
        said(|s| s.camera.aperture = 1e15 * 2.1),
        "scene: `aperture`",
    );
    starts(said(|s| s.integrator.samples = 0), "scene: `samples`");
    starts(said(|s| s.integrator.bounces = 65), "scene: `bounces`");
    starts(
        said(|s| s.integrator.reflections = 65),
        "scene: `reflections`",
    );
    starts(
        said(|s| s.shapes[0].velocity.y = f64::INFINITY),
        "shape 0 (sphere): `velocity`",
    );
    starts(
        said(|s| {
            s.shapes[0].transform.translate.x = 9e14;
            s.shapes[0].velocity.x = -3e14;
        }),
        "shape 0 (sphere): the shape reaches",
    );
}

#[test]
fn texture_coordinates_are_checked() {
    let message = |edit: fn(&mut Mesh)| said(|s| s.shapes.push(super::tests::edited(edit)));
    starts(
        message(|m| m.uvs = vec![[0.0, f64::NAN]]),
        "shape 2 (mesh): texture coordinates 0: `uv`",
    );
    starts(
        message(|m| m.triangle_uvs = vec![[0; 3]]),
        "shape 2 (mesh): triangle 0: texture coordinates 0",
    );
    starts(
        message(|m| (m.uvs, m.triangle_uvs) = (vec![[0.0; 2]], vec![[0; 3]; 2])),
        "shape 2 (mesh): triangle_uvs has 2",
    );
}

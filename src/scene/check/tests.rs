use glam::DMat3;

use super::*;
use crate::scene::{
    Background, Camera, Falloff, Image, Light, Material, PixelSampling, Transfer, Transform,
};

pub(super) fn valid() -> Scene {
    Scene {
        image: Image {
            width: 2,
            height: 2,
            transfer: Transfer::Srgb,
        },
        camera: Camera {
            eye: DVec3::Z,
            target: DVec3::ZERO,
            up: DVec3::Y,
            fov_degrees: 60.0,
            sampling: PixelSampling::Center,
            ..Camera::default()
        },
        background: Background::plain([0.0; 3]),
        ambient: [0.1; 3],
        lights: vec![Light::Point {
            position: DVec3::ONE,
            color: [1.0; 3],
            falloff: Falloff::None,
            shadow: false,
        }],
        materials: vec![Material {
            name: "grey".into(),
            albedo: [0.5; 3],
            ..Material::default()
        }],
        shapes: vec![placed(sphere(1.0)), placed(mesh())],
        groups: Vec::new(),
        ..Scene::default()
    }
}

fn placed(geometry: Geometry) -> Shape {
    Shape {
        geometry,
        transform: Transform::default(),
        material: 0,
        velocity: glam::DVec3::ZERO,
    }
}

fn sphere(radius: f64) -> Geometry {
    Geometry::Sphere {
        center: DVec3::ZERO,
        radius,
    }
}

fn mesh() -> Geometry {
    Geometry::Mesh(Arc::new(Mesh {
        positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
        triangles: vec![[0, 1, 2]],
        normals: vec![DVec3::Z],
        triangle_normals: vec![[0; 3]],
        triangle_materials: vec![0],
        ..Mesh::default()
    }))
}

pub(super) fn edited(edit: impl FnOnce(&mut Mesh)) -> Shape {
    let Geometry::Mesh(mut shared) = mesh() else {
        unreachable!("`mesh` makes a mesh");
    };
    edit(Arc::make_mut(&mut shared));
    placed(Geometry::Mesh(shared))
}

#[test]
fn a_valid_scene_passes() {
    valid().validate().expect("valid");
    let mut empty = valid();
    empty.shapes.clear();
    empty.validate().expect("an empty scene is a background");
}

/// What is wrong with the scene after an edit.
pub(super) fn said(edit: impl FnOnce(&mut Scene)) -> String {
    let mut scene = valid();
    edit(&mut scene);
    match scene.validate() {
        Err(Error::Usage(message)) => message,
        other => panic!("{other:?}"),
    }
}

pub(super) fn starts(message: String, start: &str) {
    assert!(message.starts_with(start), "{message}\nwanted {start}");
}

#[test]
fn settings_are_checked() {
    starts(said(|s| s.image.width = 0), "scene: `image width` must be");
    starts(said(|s| s.image.height = 32769), "scene: `image height`");
    starts(said(|s| s.camera.eye.x = f64::NAN), "scene: `eye` must be");
    starts(said(|s| s.camera.eye = DVec3::ZERO), "scene: `target`");
    starts(said(|s| s.camera.up = DVec3::Z), "scene: `up` [0, 0, 1]");
    starts(said(|s| s.camera.up = DVec3::ZERO), "scene: `up`");
    starts(said(|s| s.camera.fov_degrees = 180.0), "scene: `fov`");
    starts(
        said(|s| s.background.to[1] = -1.0),
        "scene: `background to`",
    );
    starts(
        said(|s| s.background.slope = f64::INFINITY),
        "scene: `background slope`",
    );
    starts(said(|s| s.ambient[0] = f64::NAN), "scene: `ambient`");
    starts(
        said(|s| s.materials[0].albedo[2] = 1.5),
        "material 0 (grey): `albedo`",
    );
}

#[test]
fn lights_are_checked_and_numbered() {
    let dark = Light::Directional {
        direction: DVec3::ZERO,
        color: [1.0; 3],
        shadow: false,
    };
    starts(said(|s| s.lights.push(dark)), "light 1: `direction`");
}

#[test]
fn shapes_are_checked_and_numbered() {
    let message = said(|s| s.shapes.push(placed(sphere(-1.0))));
    starts(
        message,
        "shape 2 (sphere): `radius` must be greater than 0, but is -1",
    );
    starts(
        said(|s| s.shapes[0].material = 1),
        "shape 0 (sphere): material 1 does not exist",
    );
    let plane = Geometry::Plane {
        point: DVec3::ZERO,
        normal: DVec3::ZERO,
    };
    starts(
        said(|s| s.shapes.push(placed(plane))),
        "shape 2 (plane): `normal`",
    );
    let disk = Geometry::Disk {
        center: DVec3::ZERO,
        normal: DVec3::X,
        radius: 0.0,
    };
    starts(
        said(|s| s.shapes.push(placed(disk))),
        "shape 2 (disk): `radius`",
    );
    let flat = Geometry::Triangle {
        vertices: [DVec3::ZERO, DVec3::ONE, DVec3::splat(3.0)],
    };
    starts(
        said(|s| s.shapes.push(placed(flat))),
        "shape 2 (triangle): the triangle",
    );
}

#[test]
fn transforms_are_checked() {
    let flat = DMat3::from_diagonal(DVec3::new(1.0, 0.0, 1.0));
    starts(
        said(|s| s.shapes[1].transform.linear = flat),
        "shape 1 (mesh): the transform",
    );
    let uneven = DMat3::from_diagonal(DVec3::new(1.0, 2.0, 1.0));
    starts(
        said(|s| s.shapes[0].transform.linear = uneven),
        "shape 0 (sphere): the transform",
    );
    starts(
        said(|s| s.shapes[0].transform.translate.y = 2e15),
        "shape 0 (sphere): `translate`",
    );
    let huge = DMat3::from_diagonal(DVec3::splat(1e15));
    starts(
        said(|s| {
            s.shapes[1].transform = Transform {
                linear: huge,
                translate: DVec3::X,
            }
        }),
        "shape 1 (mesh): the shape reaches",
    );
    let mut turned = valid();
    turned.shapes[0].transform.linear =
        DMat3::from_rotation_x(0.3) * DMat3::from_rotation_z(2.0) * 0.7;
    turned.shapes[1].transform.linear = uneven;
    turned
        .validate()
        .expect("a sphere may turn and scale, a mesh may stretch");
}

#[test]
fn dependent_columns_are_singular_whatever_their_rounding() {
    let a = DVec3::new(0.1, 0.2, 0.3);
    let b = DVec3::new(0.7, -0.4, 0.9);
    let m = DMat3::from_cols(a, b, a * 0.3 + b * 0.7);
    assert!(invertible(m).is_err(), "{:e}", m.determinant());
    let m = DMat3::from_cols(a, b, a * 0.3 + b * 0.7 + DVec3::splat(1e-12));
    assert!(invertible(m).is_ok(), "{:e}", m.determinant());
}

#[test]
fn what_is_valid_keeps_its_normals_finite() {
    // The smallest direction that passes, under the smallest transform.
    let least = (f64::MIN_POSITIVE.sqrt() / (MIN_SIZE * MIN_SIZE)) * (1.0 + CANCELLED);
    assert!(direction("normal", DVec3::Y * least).is_ok());
    assert!(direction("normal", DVec3::Y * (least * 0.9)).is_err());
    let smallest = DMat3::from_diagonal(DVec3::splat(MIN_SIZE));
    assert!(invertible(smallest).is_ok());
    assert!(invertible(smallest * 0.9).is_err());
    let cofactor = smallest.y_axis.cross(smallest.z_axis).x;
    assert!((DVec3::Y * least * cofactor).normalize().is_finite());
}

#[test]
fn meshes_are_checked() {
    type Edit = fn(&mut Mesh);
    let edits: [(Edit, &str); 10] = [
        (|m| m.positions[2].z = f64::NAN, "vertex 2: `position`"),
        (|m| m.normals[0] = DVec3::ZERO, "vertex normal 0: `normal`"),
        (|m| m.triangles[0][1] = 3, "triangle 0: vertex 3"),
        (
            |m| m.triangle_normals[0][0] = 1,
            "triangle 0: vertex normal 1",
        ),
        (
            |m| m.triangle_normals.push([0; 3]),
            "triangle_normals has 2 entries",
        ),
        (
            |m| m.uvs = vec![[0.0, f64::NAN]],
            "texture coordinates 0: `uv`",
        ),
        (
            |m| m.triangle_uvs = vec![[0; 3]],
            "triangle 0: texture coordinates 0",
        ),
        (
            |m| (m.uvs, m.triangle_uvs) = (vec![[0.0; 2]], vec![[0; 3]; 2]),
            "triangle_uvs has 2 entries",
        ),
        (
            |m| m.triangle_materials.push(0),
            "triangle_materials has 2 entries",
        ),
        (|m| m.triangle_materials[0] = 1, "triangle 0: material 1"),
    ];
    for (edit, message) in edits {
        let shape = edited(edit);
        starts(
            said(|s| s.shapes.push(shape)),
            &format!("shape 2 (mesh): {message}"),
        );
    }
    let mut with_flat_face = valid();
    with_flat_face
        .shapes
        .push(edited(|m| m.triangles[0] = [1, 1, 1]));
    with_flat_face.validate().expect("no ray meets such a face");
}

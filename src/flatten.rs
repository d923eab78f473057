//! From the scene to plain arrays: the same bytes for both tracers.
//!
//! Everything is placed relative to the camera in f64 before it is rounded, so
//! a scene far from the origin loses nothing. A transform's translation meets
//! the camera's position first, then the small coordinates.

use glam::{DMat3, DVec3};

use crate::flat::Flat;
use crate::kernel::real::Real;
use crate::layout::{
    CameraRecord, CornerNormals, Disk, LightRecord, MaterialRecord, Plane, Sphere, Surroundings,
    Triangle,
};
use crate::scene::{
    Camera, Falloff, Geometry, Light, Mesh, PixelSampling, Scene, Shape, Transform,
};

/// Flattens a valid scene (see [`Scene::validate`]).
pub fn flatten<R: Real>(scene: &Scene) -> Flat<R> {
    let eye = scene.camera.eye;
    let mut flat = Flat {
        size: [scene.image.width, scene.image.height],
        camera: camera_record(&scene.camera, scene.image.width, scene.image.height),
        surroundings: Surroundings {
            start: color(scene.background.from),
            offset: scene.background.offset as f32,
            end: color(scene.background.to),
            slope: scene.background.slope as f32,
            ambient: color(scene.ambient),
            point_lights: 0,
        },
        lights: Vec::new(),
        materials: Vec::new(),
        material_indices: Vec::new(),
        spheres: Vec::new(),
        planes: Vec::new(),
        disks: Vec::new(),
        triangles: Vec::new(),
        corner_normals: Vec::new(),
        pairs: Vec::new(),
        leaf_ids: Vec::new(),
    };
    for material in &scene.materials {
        flat.materials.push(MaterialRecord {
            albedo: color(material.albedo),
            padding: 0.0,
        });
    }
    push_lights(&mut flat, &scene.lights, eye);
    push_shapes(&mut flat, scene);
    flat
}

/// The camera's axes, scaled so that they reach the picture's edges at distance
/// 1 from the eye.
fn camera_record<R: Real>(camera: &Camera, width: u32, height: u32) -> CameraRecord<R> {
    let forward = (camera.target - camera.eye).normalize();
    let right = forward.cross(camera.up).normalize();
    let up = right.cross(forward);
    let half_height = (camera.fov_degrees.to_radians() / 2.0).tan();
    let half_width = half_height * f64::from(width) / f64::from(height);
    let (offset_x, offset_y) = match camera.sampling {
        PixelSampling::Center => (0.5, 0.5),
        PixelSampling::Corner => (0.0, 1.0),
    };
    CameraRecord {
        right: real_vector(right * half_width),
        offset_x: R::from_f64(offset_x),
        up: real_vector(up * half_height),
        offset_y: R::from_f64(offset_y),
        forward: real_vector(forward),
        padding: R::ZERO,
    }
}

fn push_lights<R>(flat: &mut Flat<R>, lights: &[Light], eye: DVec3) {
    for light in lights {
        if let Light::Point {
            position,
            color: light_color,
            falloff,
        } = *light
        {
            flat.lights.push(LightRecord {
                vector: (position - eye).as_vec3().to_array(),
                inverse_square: u32::from(falloff == Falloff::InverseSquare),
                color: color(light_color),
                padding: 0.0,
            });
        }
    }
    flat.surroundings.point_lights = flat.lights.len() as u32;
    for light in lights {
        if let Light::Directional {
            direction,
            color: light_color,
        } = *light
        {
            flat.lights.push(LightRecord {
                vector: direction.normalize().as_vec3().to_array(),
                inverse_square: 0,
                color: color(light_color),
                padding: 0.0,
            });
        }
    }
}

/// The primitives kind by kind, so that ids run through each kind in the order
/// of the scene.
fn push_shapes<R: Real>(flat: &mut Flat<R>, scene: &Scene) {
    let eye = scene.camera.eye;
    for shape in &scene.shapes {
        if let Geometry::Sphere { center, radius } = shape.geometry {
            flat.spheres.push(Sphere {
                center: real_vector(place(center, &shape.transform, eye)),
                radius: R::from_f64(radius * uniform_scale(&shape.transform)),
            });
            flat.material_indices.push(shape.material as u32);
        }
    }
    for shape in &scene.shapes {
        if let Geometry::Plane { point, normal } = shape.geometry {
            let normal = turn(normal, &shape.transform);
            let foot = normal * place(point, &shape.transform, eye).dot(normal);
            flat.planes.push(Plane {
                point: real_vector(foot),
                padding_0: R::ZERO,
                normal: real_vector(normal),
                padding_1: R::ZERO,
            });
            flat.material_indices.push(shape.material as u32);
        }
    }
    for shape in &scene.shapes {
        if let Geometry::Disk {
            center,
            normal,
            radius,
        } = shape.geometry
        {
            flat.disks.push(Disk {
                center: real_vector(place(center, &shape.transform, eye)),
                radius: R::from_f64(radius * uniform_scale(&shape.transform)),
                normal: real_vector(turn(normal, &shape.transform)),
                padding: R::ZERO,
            });
            flat.material_indices.push(shape.material as u32);
        }
    }
    for shape in &scene.shapes {
        match &shape.geometry {
            Geometry::Triangle { vertices } => {
                let [a, b, c] = vertices.map(|v| place(v, &shape.transform, eye));
                push_triangle(flat, [a, b, c]);
                flat.material_indices.push(shape.material as u32);
            }
            Geometry::Mesh(mesh) => push_mesh(flat, mesh, shape, eye),
            _ => {}
        }
    }
    if !flat.corner_normals.is_empty() {
        flat.corner_normals
            .resize(flat.triangles.len(), CornerNormals::default());
    }
}

fn push_mesh<R: Real>(flat: &mut Flat<R>, mesh: &Mesh, shape: &Shape, eye: DVec3) {
    let placed: Vec<DVec3> = mesh
        .positions
        .iter()
        .map(|&p| place(p, &shape.transform, eye))
        .collect();
    if !mesh.triangle_normals.is_empty() {
        flat.corner_normals
            .resize(flat.triangles.len(), CornerNormals::default());
        let turned: Vec<[f32; 3]> = mesh
            .normals
            .iter()
            .map(|&n| turn(n, &shape.transform).as_vec3().to_array())
            .collect();
        flat.corner_normals
            .extend(mesh.triangle_normals.iter().map(|corners| {
                let [a, b, c] = corners.map(|corner| turned[corner as usize]);
                CornerNormals {
                    a,
                    padding_0: 0.0,
                    b,
                    padding_1: 0.0,
                    c,
                    padding_2: 0.0,
                }
            }));
    }
    for triangle in &mesh.triangles {
        push_triangle(flat, triangle.map(|corner| placed[corner as usize]));
    }
    if mesh.triangle_materials.is_empty() {
        let materials = flat.material_indices.len() + mesh.triangles.len();
        flat.material_indices
            .resize(materials, shape.material as u32);
    } else {
        flat.material_indices.extend(&mesh.triangle_materials);
    }
}

fn push_triangle<R: Real>(flat: &mut Flat<R>, [a, b, c]: [DVec3; 3]) {
    flat.triangles.push(Triangle {
        a: real_vector(a),
        padding_0: R::ZERO,
        b: real_vector(b),
        padding_1: R::ZERO,
        c: real_vector(c),
        padding_2: R::ZERO,
    });
}

/// From a shape's own coordinates to camera-relative ones.
fn place(point: DVec3, transform: &Transform, eye: DVec3) -> DVec3 {
    transform.linear * point + (transform.translate - eye)
}

/// A normal's direction under a transform: by the inverse transpose, unit
/// length.
fn turn(normal: DVec3, transform: &Transform) -> DVec3 {
    let cofactors = DMat3::from_cols(
        transform.linear.y_axis.cross(transform.linear.z_axis),
        transform.linear.z_axis.cross(transform.linear.x_axis),
        transform.linear.x_axis.cross(transform.linear.y_axis),
    );
    (cofactors * normal * transform.linear.determinant().signum()).normalize()
}

/// The factor by which a transform scales lengths; spheres and disks take only
/// transforms that scale all directions alike.
fn uniform_scale(transform: &Transform) -> f64 {
    transform.linear.determinant().abs().cbrt()
}

fn real_vector<R: Real>(v: DVec3) -> [R; 3] {
    v.to_array().map(R::from_f64)
}

fn color(rgb: [f64; 3]) -> [f32; 3] {
    rgb.map(|channel| channel as f32)
}

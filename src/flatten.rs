//! From the scene to plain arrays: the same bytes for both tracers.
//!
//! Everything is placed relative to the camera in f64 before it is rounded, so
//! a scene far from the origin loses nothing. A transform's translation meets
//! the camera's position first, then the small coordinates.

mod energies;
mod finish;
mod lamps;
mod mesh;
mod shutter;
mod sky;
mod textures;

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use glam::{DMat3, DVec3};

use self::energies::energies;
use self::finish::{finish, fog, sampling};
use self::lamps::{push_forms, push_lamps};
use self::shutter::{lens, push_velocity, velocity_of};
use self::sky::flatten_sky;
use self::textures::Textures;
use crate::flat::{Flat, GivenBound, Part};
use crate::kernel::near_spheres::FAR;
use crate::kernel::real::{Real, constant};
use crate::layout::{
    BallRecord, BoxRecord, CameraRecord, Corners, Disk, Environment, LightRecord, MaterialRecord,
    NONE, Plane, SHADOW, Sphere, Surroundings, WEAKENS,
};
use crate::scene::{
    Camera, Falloff, Geometry, GroupBound, Light, Material, PixelSampling, Scene, Shape, Transform,
};

/// The power of the camera, in parts of a sphere's square radius, below which the camera is
/// near: what f32 computes of it then lacks two bits and more.
const NEAR: f64 = 0.25;

/// The kinds in the order of the ids.
const SPHERES: u32 = 0;
const PLANES: u32 = 1;
const DISKS: u32 = 2;
const TRIANGLES: u32 = 3;

/// Flattens a valid scene (see [`Scene::validate`]).
pub fn flatten<R: Real>(scene: &Scene) -> Flat<R> {
    flatten_with_ids(scene).0
}

/// Flattens a valid scene, and gives the ids of each shape, then of each lamp that has a size.
pub fn flatten_with_ids<R: Real>(scene: &Scene) -> (Flat<R>, Vec<Range<u32>>) {
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
        finishes: scene.materials.iter().map(finish).collect(),
        sampling: sampling(scene),
        samples: scene.integrator.samples,
        energies: Vec::new(),
        lamps: Vec::new(),
        environment: Environment::default(),
        sky: Arc::default(),
        lens: lens(&scene.camera),
        camera_velocity: scene.camera.velocity.as_vec3().to_array(),
        velocities: Vec::new(),
        velocity_rows: Vec::new(),
        fog: fog(scene),
        textures: Vec::new(),
        texels: Arc::default(),
        material_indices: Vec::new(),
        spheres: Vec::new(),
        sphere_ids: Vec::new(),
        planes: Vec::new(),
        disks: Vec::new(),
        disk_ids: Vec::new(),
        triangles: Vec::new(),
        vertices: Vec::new(),
        vertex_normals: Vec::new(),
        vertex_uvs: Vec::new(),
        parts: Vec::new(),
        volumes: Vec::new(),
        balls: Vec::new(),
        boxes: Vec::new(),
        tile_words: 0,
        tile_masks: OnceLock::new(),
        pairs: Vec::new(),
    };
    for material in &scene.materials {
        flat.materials.push(MaterialRecord {
            albedo: color(material.albedo),
            padding: 0.0,
        });
    }
    flat.energies = energies(&mut flat.finishes);
    push_textures(&mut flat, &scene.materials, eye);
    push_lights(&mut flat, &scene.lights, eye);
    push_lamps(&mut flat, &scene.lights, eye);
    if let Some(environment) = &scene.environment {
        (flat.environment, flat.sky) = flatten_sky(environment);
    }
    let ids = push_shapes(&mut flat, scene);
    flat.parts = parts(scene, &ids);
    (flat, ids)
}

/// Rightward, upward and forward, of unit length.
fn camera_axes(camera: &Camera) -> [DVec3; 3] {
    let forward = (camera.target - camera.eye).normalize();
    let right = forward.cross(camera.up).normalize();
    [right, right.cross(forward), forward]
}

fn push_textures<R>(flat: &mut Flat<R>, materials: &[Material], eye: DVec3) {
    let mut textures = Textures::default();
    for (material, finish) in materials.iter().zip(&mut flat.finishes) {
        finish.texture = textures.add(material, eye).unwrap_or(NONE);
        finish.is_cutout &= u32::from(finish.texture != NONE);
    }
    flat.textures = textures.records;
    flat.texels = Arc::new(textures.texels);
}

/// The camera's axes, scaled so that they reach the picture's edges at distance
/// 1 from the eye.
fn camera_record<R: Real>(camera: &Camera, width: u32, height: u32) -> CameraRecord<R> {
    let [right, up, forward] = camera_axes(camera);
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
            shadow,
        } = *light
        {
            flat.lights.push(LightRecord {
                vector: (position - eye).as_vec3().to_array(),
                flags: light_flags(falloff == Falloff::InverseSquare, shadow),
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
            shadow,
        } = *light
        {
            flat.lights.push(LightRecord {
                vector: direction.normalize().as_vec3().to_array(),
                flags: light_flags(false, shadow),
                color: color(light_color),
                padding: 0.0,
            });
        }
    }
}

fn light_flags(weakens: bool, throws_shadows: bool) -> u32 {
    let flag = |flag, is_set| if is_set { flag } else { 0 };
    flag(WEAKENS, weakens) | flag(SHADOW, throws_shadows)
}

/// The primitives kind by kind, so that ids run through each kind in the order
/// of the scene, lamps behind shapes. Gives the ids of each shape, then of each lamp.
fn push_shapes<R: Real>(flat: &mut Flat<R>, scene: &Scene) -> Vec<Range<u32>> {
    let mut ids = vec![0..0; scene.shapes.len() + flat.lamps.len()];
    let (of_shapes, of_lamps) = ids.split_at_mut(scene.shapes.len());
    let (eye, lamp_material) = (scene.camera.eye, scene.materials.len());
    for kind in [SPHERES, PLANES, DISKS, TRIANGLES] {
        for (shape, ids) in scene.shapes.iter().zip(&mut *of_shapes) {
            if kind_rank(&shape.geometry) == kind {
                let first = flat.primitives();
                push_shape(flat, shape, &scene.materials, eye);
                *ids = first..flat.primitives();
                push_velocity(flat, shape, ids.clone());
            }
        }
        push_forms(flat, &scene.lights, eye, kind, lamp_material, of_lamps);
    }
    if flat.has_moving_shapes() {
        flat.velocity_rows.resize(flat.material_indices.len(), 0);
    }
    if !flat.vertex_normals.is_empty() {
        flat.vertex_normals.resize(flat.vertices.len(), [0.0; 3]);
    }
    if !flat.vertex_uvs.is_empty() {
        flat.vertex_uvs.resize(flat.vertices.len(), [0.0; 2]);
    }
    ids
}

/// The place of a kind in the order of the ids.
fn kind_rank(geometry: &Geometry) -> u32 {
    match geometry {
        Geometry::Sphere { .. } => SPHERES,
        Geometry::Plane { .. } => PLANES,
        Geometry::Disk { .. } => DISKS,
        Geometry::Triangle { .. } | Geometry::Mesh(_) => TRIANGLES,
    }
}

fn push_shape<R: Real>(flat: &mut Flat<R>, shape: &Shape, materials: &[Material], eye: DVec3) {
    let transform = &shape.transform;
    match &shape.geometry {
        Geometry::Sphere { center, radius } => {
            flat.sphere_ids.push(flat.primitives());
            let (center, radius) = placed_sphere(transform, *center, *radius, eye);
            // A sphere that moves has another power at each time.
            let power = match velocity_of(shape) {
                None => camera_power(center.to_array(), radius),
                Some(_) => None,
            };
            flat.spheres.push(Sphere {
                center: real_vector(center),
                radius: R::from_f64(radius),
                power: power.map_or(constant(FAR), R::from_f64),
                padding: [R::ZERO; 3],
            });
        }
        Geometry::Plane { point, normal } => {
            let normal = turn(*normal, transform);
            let foot = normal * place(*point, transform, eye).dot(normal);
            flat.planes.push(Plane {
                point: real_vector(foot),
                padding_0: R::ZERO,
                normal: real_vector(normal),
                padding_1: R::ZERO,
            });
        }
        Geometry::Disk {
            center,
            normal,
            radius,
        } => {
            flat.disk_ids.push(flat.primitives());
            flat.disks.push(Disk {
                center: real_vector(place(*center, transform, eye)),
                radius: R::from_f64(radius * uniform_scale(transform)),
                normal: real_vector(turn(*normal, transform)),
                padding: R::ZERO,
            });
        }
        Geometry::Triangle { vertices } => {
            let first = flat.vertices.len() as u32;
            let id = flat.primitives();
            let mut placed = vertices.map(|v| real_vector(place(v, transform, eye)));
            let material = materials.get(shape.material);
            if material.is_some_and(|material| is_turned_inside_out(transform, material)) {
                placed.swap(0, 1);
            }
            flat.vertices.extend(placed);
            flat.triangles.push(Corners {
                vertices: [first, first + 1, first + 2],
                id,
            });
        }
        Geometry::Mesh(mesh) => return mesh::push_mesh(flat, mesh, shape, materials, eye),
    }
    flat.material_indices.push(shape.material as u32);
}

/// |center|^2 - radius^2 where it is much smaller than its terms: where the camera is near
/// the surface. It is summed with the errors of its products, so that f64 has it whole.
pub(crate) fn camera_power([x, y, z]: [f64; 3], radius: f64) -> Option<f64> {
    let terms = [(x, x), (y, y), (z, z), (-radius, radius)];
    let products = terms.map(|(a, b)| a * b);
    let errors = terms.map(|(a, b)| a.mul_add(b, -(a * b)));
    let (mut power, mut rest) = (0.0, 0.0);
    for product in products {
        let sum: f64 = power + product;
        let part = sum - power;
        rest += (power - (sum - part)) + (product - part);
        power = sum;
    }
    power += rest + errors.iter().sum::<f64>();
    (power.abs() < radius * radius * NEAR).then_some(power)
}

/// The groups of the scene, then its meshes. `ids` tells those of each shape.
fn parts<R: Real>(scene: &Scene, ids: &[Range<u32>]) -> Vec<Part<R>> {
    let eye = scene.camera.eye;
    let mut parts: Vec<Part<R>> = scene
        .groups
        .iter()
        .map(|group| Part {
            parent: group.parent,
            is_mesh: false,
            given: given_bound(group.bound, eye),
            ids: Vec::new(),
        })
        .collect();
    let mut holders = vec![None; scene.shapes.len()];
    for (group, index) in scene.groups.iter().zip(0..) {
        holders[group.shapes.clone()].fill(Some(index));
    }
    for ((shape, ids), holder) in scene.shapes.iter().zip(ids).zip(holders) {
        match (&shape.geometry, holder) {
            (Geometry::Mesh(_), parent) => parts.push(Part {
                parent,
                is_mesh: true,
                given: None,
                ids: vec![ids.clone()],
            }),
            (_, Some(group)) => parts[group].ids.push(ids.clone()),
            (_, None) => {}
        }
    }
    parts
}

fn given_bound<R: Real>(bound: GroupBound, eye: DVec3) -> Option<GivenBound<R>> {
    match bound {
        GroupBound::Auto => None,
        GroupBound::Ball { center, radius } => Some(GivenBound::Ball(BallRecord {
            center: real_vector(center - eye),
            radius: R::from_f64(radius),
        })),
        GroupBound::Box { low, high } => Some(GivenBound::Box(BoxRecord {
            low: (low - eye).as_vec3().to_array(),
            padding_0: 0.0,
            high: (high - eye).as_vec3().to_array(),
            padding_1: 0.0,
        })),
    }
}

/// Middle, camera-relative, and radius of a sphere.
pub(crate) fn placed_sphere(
    transform: &Transform,
    center: DVec3,
    radius: f64,
    eye: DVec3,
) -> (DVec3, f64) {
    (
        place(center, transform, eye),
        radius * uniform_scale(transform),
    )
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

/// Whether a transform that mirrors makes the inside of a clear body its outside: triangles
/// tell them apart by the order of their corners. Elsewhere the order counts for nothing.
fn is_turned_inside_out(transform: &Transform, material: &Material) -> bool {
    material.ior.is_some() && transform.linear.determinant() < 0.0
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

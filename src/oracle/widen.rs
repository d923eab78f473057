//! A scene of f32 as one of f64 with the same numbers: what a tracer in f32 was given, for
//! the oracle to judge it by.

use std::sync::OnceLock;

use crate::flat::{Flat, GivenBound, Part};
use crate::kernel::camera::Ray;
use crate::kernel::vector::{Vec3, vec3};
use crate::layout::{CameraRecord, Disk, Plane, Sphere};

/// The scene with the same numbers, rows, ids and volumes.
pub fn widen(flat: &Flat<f32>) -> Flat<f64> {
    Flat {
        size: flat.size,
        camera: CameraRecord {
            right: flat.camera.right.map(f64::from),
            offset_x: f64::from(flat.camera.offset_x),
            up: flat.camera.up.map(f64::from),
            offset_y: f64::from(flat.camera.offset_y),
            forward: flat.camera.forward.map(f64::from),
            padding: 0.0,
        },
        surroundings: flat.surroundings,
        lights: flat.lights.clone(),
        materials: flat.materials.clone(),
        material_indices: flat.material_indices.clone(),
        spheres: flat.spheres.iter().map(wide_sphere).collect(),
        sphere_ids: flat.sphere_ids.clone(),
        planes: flat.planes.iter().map(wide_plane).collect(),
        disks: flat.disks.iter().map(wide_disk).collect(),
        disk_ids: flat.disk_ids.clone(),
        triangles: flat.triangles.clone(),
        vertices: flat.vertices.iter().map(|v| v.map(f64::from)).collect(),
        vertex_normals: flat.vertex_normals.clone(),
        parts: flat.parts.iter().map(wide_part).collect(),
        volumes: flat.volumes.clone(),
        balls: flat.balls.iter().map(wide_sphere).collect(),
        boxes: flat.boxes.clone(),
        tile_words: flat.tile_words,
        tile_masks: OnceLock::new(),
        pairs: flat.pairs.clone(),
    }
}

/// The same ray. That of a pixel is to be made in f32 and then widened: f64 would make
/// another.
pub fn widen_ray(ray: Ray<f32>) -> Ray<f64> {
    Ray {
        origin: wide_vector(ray.origin),
        direction: wide_vector(ray.direction),
    }
}

fn wide_vector(v: Vec3<f32>) -> Vec3<f64> {
    vec3(f64::from(v.x), f64::from(v.y), f64::from(v.z))
}

fn wide_sphere(sphere: &Sphere<f32>) -> Sphere<f64> {
    Sphere {
        center: sphere.center.map(f64::from),
        radius: f64::from(sphere.radius),
    }
}

fn wide_plane(plane: &Plane<f32>) -> Plane<f64> {
    Plane {
        point: plane.point.map(f64::from),
        normal: plane.normal.map(f64::from),
        ..Plane::default()
    }
}

fn wide_disk(disk: &Disk<f32>) -> Disk<f64> {
    Disk {
        center: disk.center.map(f64::from),
        radius: f64::from(disk.radius),
        normal: disk.normal.map(f64::from),
        padding: 0.0,
    }
}

fn wide_part(part: &Part<f32>) -> Part<f64> {
    let given = part.given.map(|given| match given {
        GivenBound::Ball(ball) => GivenBound::Ball(wide_sphere(&ball)),
        GivenBound::Box(given) => GivenBound::Box(given),
    });
    Part {
        parent: part.parent,
        is_mesh: part.is_mesh,
        given,
        ids: part.ids.clone(),
    }
}

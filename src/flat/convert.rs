//! The same scene in other numbers.

use std::sync::OnceLock;

use super::{Flat, GivenBound, Part};
use crate::kernel::real::Real;
use crate::layout::{BallRecord, CameraRecord, Disk, Plane, Sphere};

impl<R: Real> Flat<R> {
    /// The scene with each number rounded to, or widened to, another width: the same rows,
    /// the same volumes.
    pub fn converted<S: Real>(&self) -> Flat<S> {
        Flat {
            size: self.size,
            camera: self.camera.converted(),
            surroundings: self.surroundings,
            lights: self.lights.clone(),
            materials: self.materials.clone(),
            finishes: self.finishes.clone(),
            sampling: self.sampling,
            samples: self.samples,
            energies: self.energies.clone(),
            lamps: self.lamps.clone(),
            environment: self.environment,
            sky: self.sky.clone(),
            lens: self.lens,
            camera_velocity: self.camera_velocity,
            velocities: self.velocities.clone(),
            velocity_rows: self.velocity_rows.clone(),
            fog: self.fog,
            textures: self.textures.clone(),
            texels: self.texels.clone(),
            material_indices: self.material_indices.clone(),
            spheres: self.spheres.iter().map(convert_sphere).collect(),
            sphere_ids: self.sphere_ids.clone(),
            planes: self.planes.iter().map(convert_plane).collect(),
            disks: self.disks.iter().map(convert_disk).collect(),
            disk_ids: self.disk_ids.clone(),
            triangles: self.triangles.clone(),
            vertices: self.vertices.iter().map(|v| v.map(convert)).collect(),
            vertex_normals: self.vertex_normals.clone(),
            vertex_uvs: self.vertex_uvs.clone(),
            parts: self.parts.iter().map(convert_part).collect(),
            volumes: self.volumes.clone(),
            balls: self.balls.iter().map(convert_ball).collect(),
            boxes: self.boxes.clone(),
            tile_words: self.tile_words,
            tile_masks: OnceLock::new(),
            pairs: self.pairs.clone(),
        }
    }
}

impl<R: Real> CameraRecord<R> {
    /// The same camera in other numbers.
    pub fn converted<S: Real>(&self) -> CameraRecord<S> {
        CameraRecord {
            right: self.right.map(convert),
            offset_x: convert(self.offset_x),
            up: self.up.map(convert),
            offset_y: convert(self.offset_y),
            forward: self.forward.map(convert),
            padding: S::ZERO,
        }
    }
}

fn convert<R: Real, S: Real>(number: R) -> S {
    S::from_f64(number.to_f64())
}

fn convert_sphere<R: Real, S: Real>(sphere: &Sphere<R>) -> Sphere<S> {
    Sphere {
        center: sphere.center.map(convert),
        radius: convert(sphere.radius),
        power: convert(sphere.power),
        padding: [S::ZERO; 3],
    }
}

fn convert_ball<R: Real, S: Real>(ball: &BallRecord<R>) -> BallRecord<S> {
    BallRecord {
        center: ball.center.map(convert),
        radius: convert(ball.radius),
    }
}

fn convert_plane<R: Real, S: Real>(plane: &Plane<R>) -> Plane<S> {
    Plane {
        point: plane.point.map(convert),
        padding_0: S::ZERO,
        normal: plane.normal.map(convert),
        padding_1: S::ZERO,
    }
}

fn convert_disk<R: Real, S: Real>(disk: &Disk<R>) -> Disk<S> {
    Disk {
        center: disk.center.map(convert),
        radius: convert(disk.radius),
        normal: disk.normal.map(convert),
        padding: S::ZERO,
    }
}

fn convert_part<R: Real, S: Real>(part: &Part<R>) -> Part<S> {
    Part {
        parent: part.parent,
        is_mesh: part.is_mesh,
        given: part.given.map(|given| match given {
            GivenBound::Ball(ball) => GivenBound::Ball(convert_ball(&ball)),
            GivenBound::Box(record) => GivenBound::Box(record),
        }),
        ids: part.ids.clone(),
    }
}

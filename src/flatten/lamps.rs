//! Lamps that have a size: what light is drawn from, and the shapes by which they are seen.

use std::f64::consts::PI;
use std::ops::Range;

use glam::DVec3;

use super::{DISKS, SPHERES, TRIANGLES, camera_power, color, real_vector};
use crate::flat::Flat;
use crate::kernel::near_spheres::FAR;
use crate::kernel::real::{Real, constant};
use crate::layout::{
    Corners, DISK_LAMP, Disk, FinishRecord, LampRecord, MaterialRecord, NONE, RECTANGLE_LAMP,
    SPHERE_LAMP, Sphere,
};
use crate::scene::{AreaForm, Light};

/// Adds the lamps that have a size, each with a material of its own. What they look like is
/// added kind by kind, see [`push_forms`].
pub(super) fn push_lamps<R>(flat: &mut Flat<R>, lights: &[Light], eye: DVec3) {
    for light in lights {
        let Light::Area { form, radiance } = light else {
            continue;
        };
        let emission = color(*radiance);
        flat.materials.push(MaterialRecord::default());
        flat.finishes.push(FinishRecord {
            emission,
            lamp: flat.lamps.len() as u32,
            texture: NONE,
            ..FinishRecord::default()
        });
        flat.lamps.push(LampRecord {
            radiance: emission,
            ..record(form, eye)
        });
    }
}

/// Where light is drawn from.
fn record(form: &AreaForm, eye: DVec3) -> LampRecord {
    let vector = |v: DVec3| v.as_vec3().to_array();
    let taxicab = |v: DVec3| v.abs().element_sum();
    match *form {
        AreaForm::Sphere { center, radius } => LampRecord {
            center: vector(center - eye),
            form: SPHERE_LAMP,
            reach: (taxicab(center - eye) + radius) as f32,
            radius: radius as f32,
            ..LampRecord::default()
        },
        AreaForm::Disk {
            center,
            normal,
            radius,
        } => {
            let normal = normal.normalize();
            let (right, up) = normal.any_orthonormal_pair();
            LampRecord {
                center: vector(center - eye),
                form: DISK_LAMP,
                right: vector(right * radius),
                reach: (taxicab(center - eye) + radius) as f32,
                up: vector(up * radius),
                normal: vector(normal),
                area: (PI * radius * radius) as f32,
                ..LampRecord::default()
            }
        }
        AreaForm::Rectangle { corner, right, up } => {
            let across = right.cross(up);
            let center = corner - eye + (right + up) / 2.0;
            LampRecord {
                center: vector(center),
                form: RECTANGLE_LAMP,
                right: vector(right / 2.0),
                reach: (taxicab(center) + taxicab(right / 2.0) + taxicab(up / 2.0)) as f32,
                up: vector(up / 2.0),
                normal: vector(across.normalize()),
                area: across.length() as f32,
                ..LampRecord::default()
            }
        }
    }
}

/// The place of the kind in the order of the ids.
fn kind_of(form: &AreaForm) -> u32 {
    match form {
        AreaForm::Sphere { .. } => SPHERES,
        AreaForm::Disk { .. } => DISKS,
        AreaForm::Rectangle { .. } => TRIANGLES,
    }
}

/// Adds the shapes of the lamps of one kind, behind those of the scene. `ids` takes those of
/// each lamp, and `first` is the first lamp's material.
pub(super) fn push_forms<R: Real>(
    flat: &mut Flat<R>,
    lights: &[Light],
    eye: DVec3,
    kind: u32,
    first: usize,
    ids: &mut [Range<u32>],
) {
    let forms = lights.iter().filter_map(|light| match light {
        Light::Area { form, .. } => Some(form),
        _ => None,
    });
    for ((form, material), ids) in forms.zip(first as u32..).zip(ids) {
        if kind_of(form) != kind {
            continue;
        }
        let begin = flat.primitives();
        match *form {
            AreaForm::Sphere { center, radius } => {
                let center = center - eye;
                flat.sphere_ids.push(begin);
                flat.spheres.push(Sphere {
                    center: real_vector(center),
                    radius: R::from_f64(radius),
                    power: camera_power(center.to_array(), radius)
                        .map_or(constant(FAR), R::from_f64),
                    padding: [R::ZERO; 3],
                });
                flat.material_indices.push(material);
            }
            AreaForm::Disk {
                center,
                normal,
                radius,
            } => {
                flat.disk_ids.push(begin);
                flat.disks.push(Disk {
                    center: real_vector(center - eye),
                    radius: R::from_f64(radius),
                    normal: real_vector(normal.normalize()),
                    padding: R::ZERO,
                });
                flat.material_indices.push(material);
            }
            AreaForm::Rectangle { corner, right, up } => {
                let vertex = flat.vertices.len() as u32;
                let corners = [corner, corner + right, corner + right + up, corner + up];
                let placed = corners.map(|corner| real_vector(corner - eye));
                flat.vertices.extend(placed);
                for (id, [second, third]) in (begin..).zip([[1, 2], [2, 3]]) {
                    flat.triangles.push(Corners {
                        vertices: [vertex, vertex + second, vertex + third],
                        id,
                    });
                    flat.material_indices.push(material);
                }
            }
        }
        *ids = begin..flat.primitives();
    }
}

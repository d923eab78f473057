//! One pixel, from its ray to its colour.

use std::ops::Range;

use super::background::background_color;
use super::camera::{Ray, camera_ray};
use super::disks::{disk_surface, test_disks};
use super::hit::{Hit, Surface, no_hit};
use super::lambert::scattered_light;
use super::planes::{closest_plane, plane_surface};
use super::probe::{Probe, probe_of};
use super::real::Real;
use super::screen::tile_of;
use super::spheres::{sphere_surface, test_spheres};
use super::tree::closest_hit;
use super::triangles::{test_triangles, triangle_surface};
use super::vector::{Vec3, vector_length};
use super::volumes::closest_in_volumes;
use crate::flat::Flat;
use crate::layout::{NO_HIT, Pixel};

/// The nearest of all primitives, by way of the volumes where there are any.
pub fn find_hit<R: Real>(flat: &Flat<R>, probe: Probe<R>, hit: &mut Hit<R>) {
    if !flat.pairs.is_empty() {
        closest_hit(flat, probe, hit);
    } else if !flat.volumes.is_empty() {
        closest_in_volumes(flat, probe, hit);
    } else {
        test_spheres(flat, probe, 0..flat.spheres.len() as u32, hit);
        closest_plane(flat, probe, hit);
        test_disks(flat, probe, 0..flat.disks.len() as u32, hit);
        test_triangles(flat, probe, 0..flat.triangles.len() as u32, hit);
    }
}

/// Tests the primitives in some rows of the table of a [`crate::flat::Kind`].
pub fn test_rows<R: Real>(
    flat: &Flat<R>,
    probe: Probe<R>,
    kind: u32,
    rows: Range<u32>,
    hit: &mut Hit<R>,
) {
    if kind == 0 {
        return test_spheres(flat, probe, rows, hit);
    }
    if kind == 1 {
        return test_disks(flat, probe, rows, hit);
    }
    test_triangles(flat, probe, rows, hit);
}

/// The surface at the ray's hit, a primitive of the scene.
pub fn surface_of<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Surface {
    sphere_surface(flat, ray, hit)
        .or_else(|| plane_surface(flat, ray, hit))
        .or_else(|| disk_surface(flat, ray, hit))
        .or_else(|| triangle_surface(flat, ray, hit))
        .unwrap_or_default()
}

/// What the ray sees at its hit.
pub fn shade_hit<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Pixel {
    let surface = surface_of(flat, ray, hit);
    let material = flat.materials[flat.material_indices[hit.id as usize] as usize];
    Pixel {
        color: scattered_light(flat, &surface, Vec3::from(material.albedo)).into(),
        depth: (hit.t * vector_length(ray.direction)).to_f32(),
        normal: surface.normal.into(),
        id: hit.id,
        position: surface.position.into(),
        tests: hit.tests,
    }
}

/// What the ray sees that meets nothing.
pub fn shade_miss<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Pixel {
    Pixel {
        color: background_color(&flat.surroundings, ray.direction.to_f32()).into(),
        id: NO_HIT,
        tests: hit.tests,
        ..Pixel::default()
    }
}

/// What the ray sees.
pub fn shade<R: Real>(flat: &Flat<R>, ray: Ray<R>, hit: Hit<R>) -> Pixel {
    if hit.id == NO_HIT {
        return shade_miss(flat, ray, hit);
    }
    shade_hit(flat, ray, hit)
}

/// Everything known of pixel (x, y), y downward from the top row.
pub fn trace_pixel<R: Real>(flat: &Flat<R>, x: u32, y: u32) -> Pixel {
    let ray = camera_ray(&flat.camera, flat.size, x, y);
    let mut hit = no_hit();
    hit.tile = tile_of(flat.size, x, y);
    find_hit(flat, probe_of(ray), &mut hit);
    shade(flat, ray, hit)
}

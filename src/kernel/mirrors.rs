//! Mirrors, smooth and rough.

use super::fresnel::askew;
use super::glossy::{energy_of, glossy_light, scatter_glossily};
use super::hit::Surface;
use super::integrator::{Look, Path, send_on};
use super::mirror::{cosine_to_viewer, mirrored, normal_to_viewer};
use super::real::Real;
use super::sources::Arriving;
use super::vector::{Vec3, divided, dot_product, taxicab_length};
use crate::flat::Flat;

/// Notes what a place mirrors: by the angle to its normal, not to those of a rough mirror's
/// small ones, so that what is left for its albedo is known.
pub fn mirror_look<R: Real>(
    flat: &Flat<R>,
    look: &mut Look,
    _path: &Path<R>,
    surface: &Surface,
    material: u32,
    view: Vec3<f32>,
) {
    let finish = &flat.finishes[material as usize];
    let straight = Vec3::from(finish.mirror);
    if taxicab_length(straight) == 0.0 {
        return;
    }
    let cosine = cosine_to_viewer(normal_to_viewer(surface, view), view);
    look.reflectance = askew(straight, cosine);
    look.width = finish.width;
    if look.width > 0.0 {
        look.energy = energy_of(flat, material, look.width, cosine);
    }
}

/// What a rough mirror sends to the viewer of light that was searched for: `color` is what a
/// white surface would look like by it. In a smooth mirror such light is seen only where a path
/// finds it.
pub fn mirrored_light<R: Real>(
    flat: &Flat<R>,
    path: &Path<R>,
    surface: &Surface,
    look: &Look,
    view: Vec3<f32>,
    arriving: &Arriving,
    color: Vec3<f32>,
) -> Vec3<f32> {
    if look.width == 0.0 {
        return Vec3::default();
    }
    glossy_light(flat, path, surface, look, view, arriving, color)
}

/// Has the path go on as a mirror sends it, smooth or rough.
pub fn mirror_light<R: Real>(
    path: &mut Path<R>,
    surface: &Surface,
    look: &Look,
    view: Vec3<f32>,
) -> bool {
    if path.reflections == 0 || taxicab_length(look.reflectance) == 0.0 {
        return false;
    }
    path.reflections -= 1;
    if look.width > 0.0 {
        return scatter_glossily(path, surface, look, view);
    }
    let direction = mirrored(-view, normal_to_viewer(surface, view));
    if dot_product(surface.facing, direction) <= 0.0 {
        return false;
    }
    path.density = 0.0;
    let left = divided(look.reflectance, 1.0 - look.evenly);
    send_on(path, surface, direction, left)
}

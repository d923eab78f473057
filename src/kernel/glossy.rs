//! Rough mirrors: they scatter light about where a smooth one would send it.

use super::dimensions::{SCATTER, dimension_of};
use super::divide::{divide, square_root};
use super::frame::{Axes, axes_around, from_axes, to_axes};
use super::hit::Surface;
use super::integrator::{Look, Path, send_on};
use super::microfacets::{INVERSE_PI, lit_by_cosine, shape_of_lobe, visible_normal};
use super::mirror::{LEAST_COSINE, mirrored, normal_to_viewer};
use super::numbers::number_pair;
use super::real::Real;
use super::sources::{Arriving, searched_weight};
use super::vector::{Vec3, divided, dot_product};
use crate::flat::Flat;

/// The energies of a width, at as many cosines.
pub const ENERGIES: u32 = 64;

/// Where an energy is in the row of its width, from 0 to the last. Half of the row is for
/// cosines up to about the width, where it changes, and the more the smaller they are.
pub fn place_of_energy(cosine: f32, width: f32) -> f32 {
    let twice = 2.0 * width;
    let part = divide(cosine * (1.0 + twice), cosine + twice);
    square_root(part) * (ENERGIES - 1) as f32
}

/// What of light a rough mirror would throw back that threw back all: the rest is what falls on
/// its small mirrors a second time, which is not followed. See `src/flatten/energies.rs`; what
/// is between two numbers of the row is off by 2^-11 of it at most.
pub fn energy_of<R: Real>(flat: &Flat<R>, material: u32, width: f32, cosine: f32) -> f32 {
    let place = place_of_energy(cosine, width);
    let whole = place as u32;
    let index = if whole < ENERGIES - 2 {
        whole
    } else {
        ENERGIES - 2
    };
    let at = flat.finishes[material as usize].energies * ENERGIES + index;
    let energy = flat.energies[at as usize];
    let next = flat.energies[at as usize + 1];
    energy + (next - energy) * (place - index as f32)
}

/// The direction of the viewer by the mirror's axes, above the surface whatever the roundings.
fn view_in(axes: Axes, view: Vec3<f32>) -> Vec3<f32> {
    let mut seen = to_axes(axes, view);
    if seen.z < LEAST_COSINE {
        seen.z = LEAST_COSINE;
    }
    seen
}

/// See `mirrored_light`. What the small mirrors throw back twice is added in the form of what
/// they throw back once: so all of it is what the reflectance says, and none is lost.
pub fn glossy_light<R: Real>(
    flat: &Flat<R>,
    path: &Path<R>,
    surface: &Surface,
    look: &Look,
    view: Vec3<f32>,
    arriving: &Arriving,
    color: Vec3<f32>,
) -> Vec3<f32> {
    let axes = axes_around(normal_to_viewer(surface, view));
    let seen = view_in(axes, view);
    let light = to_axes(axes, divided(arriving.towards, arriving.length));
    if light.z <= 0.0 {
        return Vec3::default();
    }
    let shape = shape_of_lobe(seen, light, look.width);
    let mut of_path = 0.0;
    if path.reflections > 0 {
        of_path = (1.0 - look.evenly) * (shape * INVERSE_PI);
    }
    let part = shape * lit_by_cosine(seen, light, look.width);
    let weight = searched_weight(flat, arriving.density, of_path);
    color.times(look.reflectance) * (divide(part, look.energy) * weight)
}

/// Has the path go on from a rough mirror.
pub fn scatter_glossily<R: Real>(
    path: &mut Path<R>,
    surface: &Surface,
    look: &Look,
    view: Vec3<f32>,
) -> bool {
    let axes = axes_around(normal_to_viewer(surface, view));
    let seen = view_in(axes, view);
    let pair = number_pair(path.numbers, dimension_of(path.leg, SCATTER));
    let light = mirrored(-seen, visible_normal(seen, look.width, pair));
    let direction = from_axes(axes, light.x, light.y, light.z);
    if light.z <= 0.0 || dot_product(surface.facing, direction) <= 0.0 {
        return false;
    }
    let chance = 1.0 - look.evenly;
    path.density = chance * (shape_of_lobe(seen, light, look.width) * INVERSE_PI);
    let part = light.z * lit_by_cosine(seen, light, look.width);
    let left = look.reflectance * divide(part, look.energy * chance);
    send_on(path, surface, direction, left)
}

//! This crate.

use rayproof::Unwatched;
use rayproof::cpu::search;
use rayproof::cpu::wide::Wide;
use rayproof::flat::Flat;
use rayproof::gpu::device::Gpu;
use rayproof::gpu::render::{Portions, Prepared};
use rayproof::kernel::camera::camera_ray;
use rayproof::kernel::hit::{Hit, no_hit};
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::tree::closest_hit;
use rayproof::kernel::vector::vector_length;
use rayproof::layout::NO_HIT;

use crate::{Found, Outcome, Search, Trace};

/// The tree of eight boxes a node, with which pictures are traced.
pub fn wide(flat: &Flat<f32>) -> Trace<'_> {
    let wide = Wide::new(flat);
    Box::new(move |rays, found| {
        let mut search = search::Search::new(flat, Some(&wide));
        for (ray, found) in rays.iter().zip(found) {
            let mut hit = no_hit();
            search.closest(probe_of(*ray), &mut hit);
            *found = found_of(hit);
        }
    })
}

/// The twin of the shader's search.
pub fn twin(flat: &Flat<f32>) -> Trace<'_> {
    Box::new(|rays, found| {
        for (ray, found) in rays.iter().zip(found) {
            let mut hit = no_hit();
            closest_hit(flat, probe_of(*ray), &mut hit);
            *found = found_of(hit);
        }
    })
}

/// The shader, by the device's clock: the passes that find hits.
pub fn on_gpu<'a>(gpu: &'a Gpu, flat: &'a Flat<f32>) -> Outcome<Search<'a>> {
    let portions = Portions {
        time: true,
        ..Portions::default()
    };
    let mut prepared = Prepared::new(gpu, flat, portions)?;
    let length = |x, y| vector_length(camera_ray(&flat.camera, flat.size, x, y).direction);
    Ok(Box::new(move |found| {
        let width = flat.size[0];
        prepared.run(&Unwatched, &mut |first, pixels| {
            let first = (first * width) as usize;
            for (at, (found, pixel)) in found[first..].iter_mut().zip(pixels).enumerate() {
                let at = (first + at) as u32;
                *found = if pixel.id == NO_HIT {
                    (f32::INFINITY, pixel.id)
                } else {
                    (pixel.depth / length(at % width, at / width), pixel.id)
                };
            }
        })?;
        let seconds = prepared.seconds().ok_or("the device has no clock")?;
        Ok(seconds.trace)
    }))
}

fn found_of(hit: Hit<f32>) -> Found {
    if hit.id == NO_HIT {
        (f32::INFINITY, hit.id)
    } else {
        (hit.t, hit.id)
    }
}

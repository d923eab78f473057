//! This crate.

use rayproof::cpu::search::Search;
use rayproof::cpu::wide::Wide;
use rayproof::flat::Flat;
use rayproof::kernel::hit::{Hit, no_hit};
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::tree::closest_hit;
use rayproof::layout::NO_HIT;

use crate::{Found, Trace};

/// The tree of eight boxes a node, with which pictures are traced.
pub fn wide(flat: &Flat<f32>) -> Trace<'_> {
    let wide = Wide::new(flat);
    Box::new(move |rays, found| {
        let mut search = Search::new(flat, Some(&wide));
        for (ray, found) in rays.iter().zip(found) {
            let mut hit = no_hit();
            search.find(probe_of(*ray), &mut hit);
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

fn found_of(hit: Hit<f32>) -> Found {
    if hit.id == NO_HIT {
        (f32::INFINITY, hit.id)
    } else {
        (hit.t, hit.id)
    }
}

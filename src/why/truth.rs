//! What the oracle says of the numbers that a tier is given.

use std::collections::HashMap;

use crate::flat::Flat;
use crate::kernel::camera::camera_ray;
use crate::kernel::real::Real;
use crate::layout::NO_HIT;
use crate::oracle::{Candidate, Oracle};

/// All that a ray meets, exactly, for scene and ray in the numbers of a width.
pub(super) struct Truths {
    /// What it meets first, or [`NO_HIT`].
    pub(super) first: u32,
    /// The ids in the order in which the ray meets them.
    pub(super) order: Vec<u32>,
    /// By id.
    pub(super) met: HashMap<u32, Candidate>,
}

impl Truths {
    /// Of a pixel's ray, which is made in the width, as the tier makes it.
    pub(super) fn of<R: Real>(flat: &Flat<R>, x: u32, y: u32) -> Self {
        let ray = camera_ray(&flat.camera, flat.size, x, y);
        let candidates = Oracle::new(&flat.converted()).candidates(ray.converted());
        Self {
            first: candidates.first().map_or(NO_HIT, |first| first.id),
            order: candidates.iter().map(|candidate| candidate.id).collect(),
            met: candidates.into_iter().map(|c| (c.id, c)).collect(),
        }
    }
}

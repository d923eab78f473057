//! Paths on a device.

use super::device::Gpu;
use super::ray_list::RayList;
use crate::effects::Entry;
use crate::error::Result;
use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::kernel::path::AimRecord;
use crate::kernel::real::Real;
use crate::paths::{Aim, Paths, stretch};
use crate::tier::{Bounded, Double};

/// Follows the path of each ray, in numbers of one kind.
///
/// # Errors
///
/// As [`super::rays::trace_rays`].
pub fn follow_paths<R: Real>(
    gpu: &Gpu,
    flat: &Flat<R>,
    rays: &[Ray<f32>],
    aims: &[Aim],
    legs: u32,
) -> Result<Paths> {
    let at_once = stretch(flat).min(legs);
    let list = RayList::set_up(gpu, flat, Entry::Paths, rays.len(), at_once)?;
    follow(gpu, list, rays, aims, legs, at_once)
}

/// Follows the path of each ray with bounds of the error, and stretches in doubt once more in
/// wider numbers.
///
/// # Errors
///
/// As [`follow_paths`].
pub fn follow_adaptively(
    gpu: &Gpu,
    first: &Flat<Bounded>,
    second: &Flat<Double>,
    rays: &[Ray<f32>],
    aims: &[Aim],
    legs: u32,
) -> Result<Paths> {
    let at_once = stretch(first).min(legs);
    let list = RayList::set_up(gpu, first, Entry::Paths, rays.len(), at_once)?;
    let list = list.with_second(gpu, second, Entry::DoubtfulPaths)?;
    follow(gpu, list, rays, aims, legs, at_once)
}

/// Follows the paths, `at_once` legs at a time.
fn follow(
    gpu: &Gpu,
    mut list: RayList,
    rays: &[Ray<f32>],
    aims: &[Aim],
    legs: u32,
    at_once: u32,
) -> Result<Paths> {
    let mut found = Vec::with_capacity(rays.len() * legs as usize);
    let mut ends = Vec::with_capacity(rays.len());
    for (rays, aims) in rays.chunks(list.portion).zip(aims.chunks(list.portion)) {
        let aims: Vec<AimRecord> = aims.iter().map(|aim| aim.record()).collect();
        list.load(gpu, rays, &aims);
        let mut stretches = Vec::new();
        let mut done = 0;
        while done < legs {
            if done > 0 {
                list.go_on(gpu, rays.len());
            }
            let legs = at_once.min(legs - done);
            stretches.push((list.trace(gpu, rays.len(), legs)?, legs as usize));
            done += legs;
        }
        for ray in 0..rays.len() {
            for (found_by_all, legs) in &stretches {
                found.extend_from_slice(&found_by_all[ray * legs..(ray + 1) * legs]);
            }
        }
        ends.extend(list.ends(gpu, rays.len())?);
    }
    Ok(Paths {
        found,
        ends,
        retraced: list.retraced(),
    })
}

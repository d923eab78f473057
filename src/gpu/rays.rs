//! Any rays on a device, listed.

use super::device::Gpu;
use super::ray_list::RayList;
use crate::effects::Entry;
use crate::error::Result;
use crate::flat::Flat;
use crate::found::Found;
use crate::kernel::camera::Ray;
use crate::kernel::real::Real;
use crate::tier::{Bounded, Double};

/// Finds the closest hit of each ray, in numbers of one kind.
///
/// # Errors
///
/// As of a render; [`crate::Error::Limit`] where one dispatch cannot test everything.
pub fn trace_rays<R: Real>(gpu: &Gpu, flat: &Flat<R>, rays: &[Ray<f32>]) -> Result<Vec<Found>> {
    trace(
        gpu,
        &mut RayList::set_up(gpu, flat, Entry::Rays, rays.len(), 1)?,
        rays,
    )
}

/// Finds the closest hit of each ray with bounds of the error, and of those in doubt once
/// more in wider numbers; tells how many those are.
///
/// # Errors
///
/// As [`trace_rays`].
pub fn trace_adaptively(
    gpu: &Gpu,
    first: &Flat<Bounded>,
    second: &Flat<Double>,
    rays: &[Ray<f32>],
) -> Result<(Vec<Found>, u64)> {
    let list = RayList::set_up(gpu, first, Entry::Rays, rays.len(), 1)?;
    let mut list = list.with_second(gpu, second, Entry::DoubtfulRays)?;
    let found = trace(gpu, &mut list, rays)?;
    Ok((found, list.retraced()))
}

fn trace(gpu: &Gpu, list: &mut RayList, rays: &[Ray<f32>]) -> Result<Vec<Found>> {
    let mut found = Vec::with_capacity(rays.len());
    for rays in rays.chunks(list.portion) {
        list.load(gpu, rays, &[]);
        found.extend(list.trace(gpu, rays.len(), 1)?);
    }
    Ok(found)
}

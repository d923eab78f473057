//! Paths on the CPU.

use std::num::NonZeroUsize;

use super::rays::{for_each, for_each_twice, search_ray};
use super::search::Search;
use crate::error::Result;
use crate::flat::Flat;
use crate::found::Found;
use crate::kernel::camera::Ray;
use crate::kernel::doubt::is_in_doubt;
use crate::kernel::hit::no_hit;
use crate::kernel::path::{AimRecord, is_over, next_ray};
use crate::kernel::real::Real;
use crate::paths::{Aim, Paths, stretch};
use crate::tier::Bounded;

/// What a path's legs find, the ray after them, and how often they were followed again.
type Followed = (Vec<Found>, Ray<f32>, u64);

/// Follows the path of each ray, in numbers of one kind.
///
/// # Errors
///
/// As [`super::rays::trace_rays`].
pub fn follow_paths<R: Real>(
    flat: &Flat<R>,
    rays: &[Ray<f32>],
    aims: &[Aim],
    legs: u32,
    threads: Option<NonZeroUsize>,
) -> Result<Paths> {
    let followed = for_each(flat, &paths_of(rays, aims), threads, |search, path| {
        let (mut ray, aim) = *path;
        let mut found = Vec::with_capacity(legs as usize);
        follow(search, flat, &mut ray, aim, legs, &mut found)?;
        Ok((found, ray, 0))
    })?;
    Ok(collected(followed))
}

/// Follows the path of each ray with bounds of the error, and stretches in doubt once more in
/// f64.
///
/// # Errors
///
/// As [`follow_paths`].
pub fn follow_adaptively(
    first: &Flat<Bounded>,
    second: &Flat<f64>,
    rays: &[Ray<f32>],
    aims: &[Aim],
    legs: u32,
    threads: Option<NonZeroUsize>,
) -> Result<Paths> {
    let at_once = stretch(first);
    let paths = paths_of(rays, aims);
    let followed = for_each_twice(first, second, &paths, threads, |search, again, path| {
        let (mut ray, aim) = *path;
        let mut found = Vec::with_capacity(legs as usize);
        let mut retraced = 0;
        while (found.len() as u32) < legs {
            let (start, done) = (ray, found.len());
            let legs = at_once.min(legs - done as u32);
            if follow(search, first, &mut ray, aim, legs, &mut found)? {
                ray = start;
                found.truncate(done);
                follow(again, second, &mut ray, aim, legs, &mut found)?;
                retraced += 1;
            }
        }
        Ok((found, ray, retraced))
    })?;
    Ok(collected(followed))
}

fn paths_of(rays: &[Ray<f32>], aims: &[Aim]) -> Vec<(Ray<f32>, AimRecord)> {
    let aims = aims.iter().map(|aim| aim.record());
    rays.iter().copied().zip(aims).collect()
}

fn collected(followed: Vec<Followed>) -> Paths {
    Paths {
        ends: followed.iter().map(|(_, end, _)| *end).collect(),
        retraced: followed.iter().map(|(.., retraced)| retraced).sum(),
        found: followed.into_iter().flat_map(|(found, ..)| found).collect(),
    }
}

/// Follows a path for so many legs, or to one that is in doubt; tells whether one is.
fn follow<R: Real>(
    search: &mut Search<'_, R>,
    flat: &Flat<R>,
    ray: &mut Ray<f32>,
    aim: AimRecord,
    legs: u32,
    found: &mut Vec<Found>,
) -> Result<bool> {
    for _ in 0..legs {
        let hit = if is_over(*ray) {
            no_hit()
        } else {
            search_ray(search, ray)
        };
        found.push(Found::at(hit)?);
        if is_in_doubt(hit) {
            return Ok(true);
        }
        *ray = next_ray(flat, ray.converted(), hit, aim).converted();
    }
    Ok(false)
}

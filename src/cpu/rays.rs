//! Any rays on the CPU.

use std::num::NonZeroUsize;

use rayon::prelude::*;

use super::pool_of;
use super::search::Search;
use super::wide::Wide;
use crate::error::Result;
use crate::flat::Flat;
use crate::found::{Found, refuse_lists};
use crate::kernel::camera::Ray;
use crate::kernel::doubt::is_in_doubt;
use crate::kernel::hit::{Hit, no_hit};
use crate::kernel::probe::probe_of;
use crate::kernel::real::Real;
use crate::tier::Bounded;

/// Finds the closest hit of each ray, in numbers of one kind.
///
/// # Errors
///
/// [`crate::Error::Limit`] when no threads can be had, a ray is given up or the scene's volumes are
/// a list.
pub fn trace_rays<R: Real>(
    flat: &Flat<R>,
    rays: &[Ray<f32>],
    threads: Option<NonZeroUsize>,
) -> Result<Vec<Found>> {
    for_each(flat, rays, threads, |search, ray| {
        Found::at(search_ray(search, ray))
    })
}

/// Finds the closest hit of each ray with bounds of the error, and of those in doubt once
/// more in f64; tells how many those are.
///
/// # Errors
///
/// As [`trace_rays`].
pub fn trace_adaptively(
    first: &Flat<Bounded>,
    second: &Flat<f64>,
    rays: &[Ray<f32>],
    threads: Option<NonZeroUsize>,
) -> Result<(Vec<Found>, u64)> {
    let found = for_each_twice(first, second, rays, threads, |search, again, ray| {
        let hit = search_ray(search, ray);
        if is_in_doubt(hit) {
            return Ok((Found::at(search_ray(again, ray))?, true));
        }
        Ok((Found::at(hit)?, false))
    })?;
    let retraced = found.iter().filter(|(_, retraced)| *retraced).count();
    Ok((
        found.into_iter().map(|(found, _)| found).collect(),
        retraced as u64,
    ))
}

/// What `trace` makes of each item, by a search of the scene.
///
/// # Errors
///
/// As [`trace_rays`], and those of `trace`.
pub(super) fn for_each<R: Real, I: Sync, T: Send>(
    flat: &Flat<R>,
    items: &[I],
    threads: Option<NonZeroUsize>,
    trace: impl Fn(&mut Search<'_, R>, &I) -> Result<T> + Sync,
) -> Result<Vec<T>> {
    refuse_lists(flat)?;
    pool_of(threads)?.install(|| {
        let wide = (!flat.pairs.is_empty()).then(|| Wide::new(flat));
        let search = || Search::new(flat, wide.as_ref());
        let items = items.par_iter();
        items
            .map_init(search, |search, item| trace(search, item))
            .collect()
    })
}

/// What `trace` makes of each item, by searches of the scene in both numbers.
///
/// # Errors
///
/// As [`for_each`].
pub(super) fn for_each_twice<I: Sync, T: Send>(
    first: &Flat<Bounded>,
    second: &Flat<f64>,
    items: &[I],
    threads: Option<NonZeroUsize>,
    trace: impl Fn(&mut Search<'_, Bounded>, &mut Search<'_, f64>, &I) -> Result<T> + Sync,
) -> Result<Vec<T>> {
    refuse_lists(first)?;
    pool_of(threads)?.install(|| {
        let has_tree = !first.pairs.is_empty();
        let wide = has_tree.then(|| (Wide::new(first), Wide::new(second)));
        let (one, two) = wide.as_ref().map(|(one, two)| (one, two)).unzip();
        let search = || (Search::new(first, one), Search::new(second, two));
        let items = items.par_iter();
        items
            .map_init(search, |(search, again), item| trace(search, again, item))
            .collect()
    })
}

/// The closest hit of a ray.
pub(super) fn search_ray<R: Real>(search: &mut Search<'_, R>, ray: &Ray<f32>) -> Hit<R> {
    let mut hit = no_hit();
    search.closest(probe_of(ray.converted()), &mut hit);
    hit
}

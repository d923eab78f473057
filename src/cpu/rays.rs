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
    refuse_lists(flat)?;
    let pool = pool_of(threads)?;
    let wide = pool.install(|| (!flat.pairs.is_empty()).then(|| Wide::new(flat)));
    pool.install(|| {
        let search = || Search::new(flat, wide.as_ref());
        let hits = rays
            .par_iter()
            .map_init(search, |search, ray| search_ray(search, ray));
        hits.map(Found::at).collect()
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
    refuse_lists(first)?;
    let pool = pool_of(threads)?;
    let has_tree = !first.pairs.is_empty();
    let wide = pool.install(|| has_tree.then(|| (Wide::new(first), Wide::new(second))));
    let found: Result<Vec<(Found, bool)>> = pool.install(|| {
        let search = || {
            let (one, two) = (
                wide.as_ref().map(|(one, _)| one),
                wide.as_ref().map(|(_, two)| two),
            );
            (Search::new(first, one), Search::new(second, two))
        };
        let hits = rays.par_iter().map_init(search, |(search, again), ray| {
            let hit = search_ray(search, ray);
            if is_in_doubt(hit) {
                return Ok((Found::at(search_ray(again, ray))?, true));
            }
            Ok((Found::at(hit)?, false))
        });
        hits.collect()
    });
    let found = found?;
    let retraced = found.iter().filter(|(_, retraced)| *retraced).count();
    Ok((
        found.into_iter().map(|(found, _)| found).collect(),
        retraced as u64,
    ))
}

fn search_ray<R: Real>(search: &mut Search<'_, R>, ray: &Ray<f32>) -> Hit<R> {
    let mut hit = no_hit();
    search.closest(probe_of(ray.converted()), &mut hit);
    hit
}

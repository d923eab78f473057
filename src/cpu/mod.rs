//! The CPU tracer: threads over the kernel.

pub mod block;
pub mod paths;
pub mod rays;
pub mod sampled;
pub mod search;
pub mod wide;

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use rayon::ThreadPool;
use rayon::prelude::*;

use self::search::Search;
use self::wide::Wide;
use crate::count::{CountMap, Counted};
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::kernel::camera::{Ray, camera_ray};
use crate::kernel::doubt::is_in_doubt;
use crate::kernel::hit::{Hit, no_hit};
use crate::kernel::probe::probe_of;
use crate::kernel::real::Real;
use crate::kernel::screen::tile_of;
use crate::kernel::trace::{find_hit, shade};
use crate::layout::Pixel;
use crate::watch::Watch;

/// Rows that are traced side by side, a thread: enough that no thread waits long
/// for the last one, few enough to be held until they are handed on.
const ROWS_PER_THREAD: u32 = 16;

/// Threads at most: more than any machine has cores. Starting some ten thousand
/// takes minutes in which nothing can stop it.
pub const MAX_THREADS: usize = 1024;

/// Pixels of a patch's side: rays that go through the same nodes follow one another, and
/// between two looks at the watch there is one row of them, each of which may test ten
/// million primitives.
const PATCH: usize = 16;

/// Renders a flattened scene, once: [`Prepared::new`], then [`Prepared::run`].
///
/// # Errors
///
/// As those two.
pub fn render<R: Real>(
    flat: &Flat<R>,
    threads: Option<NonZeroUsize>,
    watch: &dyn Watch,
    keep_rows: &mut dyn FnMut(u32, &[Pixel]),
) -> Result<()> {
    Prepared::new(flat, threads)?.run(watch, keep_rows)
}

/// Counts what each ray of a picture tests. They go through the volumes as the
/// shader's rays do, not by way of [`Search`], so the counts are the same.
///
/// # Errors
///
/// As [`Prepared::new`] and [`Prepared::run`].
pub fn count<R: Real>(
    flat: &Flat<R>,
    threads: Option<NonZeroUsize>,
    watch: &dyn Watch,
) -> Result<CountMap> {
    let [width, height] = flat.size;
    let mut pixels = vec![Counted::default(); width as usize * height as usize];
    let rows_done = AtomicU64::new(0);
    let count_row = |(y, row): (usize, &mut [Counted])| {
        if watch.cancelled() {
            return Err(Error::Interrupted);
        }
        for (x, counted) in (0..).zip(row) {
            *counted = count_pixel(flat, x, y as u32)?;
        }
        let done = rows_done.fetch_add(1, Ordering::Relaxed) + 1;
        watch.progress(done as f64 / f64::from(height));
        Ok(())
    };
    pool_of(threads)?.install(|| {
        let rows = pixels.par_chunks_mut(width as usize);
        rows.enumerate().try_for_each(count_row)
    })?;
    Ok(CountMap { width, pixels })
}

fn count_pixel<R: Real>(flat: &Flat<R>, x: u32, y: u32) -> Result<Counted> {
    let mut hit = no_hit();
    hit.tile = tile_of(flat.size, x, y);
    let ray = camera_ray(&flat.camera, flat.size, x, y);
    find_hit(flat, probe_of(ray), &mut hit);
    Counted::of(hit.bound_tests, hit.bound_hits, hit.tests)
}

fn pool_of(threads: Option<NonZeroUsize>) -> Result<ThreadPool> {
    if let Some(threads) = threads.filter(|threads| threads.get() > MAX_THREADS) {
        return Err(Error::Limit(format!(
            "{threads} threads are asked for, {MAX_THREADS} are the most"
        )));
    }
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.map_or(0, NonZeroUsize::get))
        .build()
        .map_err(|error| Error::Limit(error.to_string()))
}

/// A scene and the threads that wait for it: ready to be traced, any number of
/// times.
pub struct Prepared<'a, R> {
    flat: &'a Flat<R>,
    wide: Option<Wide<R>>,
    second: Option<Second<'a>>,
    pool: ThreadPool,
    build_time: Duration,
}

impl<'a, R: Real> Prepared<'a, R> {
    /// Starts `threads` threads, or one for each core, and makes ready what the CPU has
    /// of its own: the wide tree, the masks of the screen's tiles.
    ///
    /// # Errors
    ///
    /// [`Error::Limit`] when no threads can be had or more than [`MAX_THREADS`]
    /// are asked for.
    pub fn new(flat: &'a Flat<R>, threads: Option<NonZeroUsize>) -> Result<Self> {
        let pool = pool_of(threads)?;
        let started = Instant::now();
        let wide = (!flat.pairs.is_empty()).then(|| pool.install(|| Wide::new(flat)));
        if flat.tile_words > 0 {
            // Now, not in the middle of the first picture, where all threads would wait.
            flat.tile_masks();
        }
        Ok(Self {
            flat,
            wide,
            second: None,
            pool,
            build_time: started.elapsed(),
        })
    }

    /// Has the rays that are in doubt traced again in f64: `second` is the same scene with
    /// the same volumes.
    pub fn with_second(mut self, second: &'a Flat<f64>) -> Self {
        let started = Instant::now();
        let pool = &self.pool;
        self.second = Some(Second {
            flat: second,
            wide: (!second.pairs.is_empty()).then(|| pool.install(|| Wide::new(second))),
            rays: AtomicU64::new(0),
        });
        self.build_time += started.elapsed();
        self
    }

    /// How many rays of the last picture were traced again.
    pub fn retraced(&self) -> u64 {
        let second = self.second.as_ref();
        second.map_or(0, |second| second.rays.load(Ordering::Relaxed))
    }

    /// How long it took to widen the scene's tree, or to sort volumes to tiles.
    pub fn build_time(&self) -> Duration {
        self.build_time
    }

    /// How many threads there are.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Traces all pixels. Their rows are handed to `keep_rows`, from top to
    /// bottom, together with the number of their first row.
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`] when `watch` says so.
    pub fn run(&self, watch: &dyn Watch, keep_rows: &mut dyn FnMut(u32, &[Pixel])) -> Result<()> {
        let [width, height] = self.flat.size;
        let band = ROWS_PER_THREAD * self.threads() as u32;
        let pixels_done = AtomicU64::new(0);
        let total = u64::from(width) * u64::from(height);
        let search = || {
            let second = self.second.as_ref();
            let first = Search::new(self.flat, self.wide.as_ref());
            (
                first,
                second.map(|second| Search::new(second.flat, second.wide.as_ref())),
            )
        };
        if let Some(second) = &self.second {
            second.rays.store(0, Ordering::Relaxed);
        }
        let mut first_row = 0;
        while first_row < height {
            let rows = band.min(height - first_row);
            let mut pixels = vec![Pixel::default(); rows as usize * width as usize];
            let mut patches = patches_of(&mut pixels, width as usize);
            self.pool.install(|| {
                patches
                    .par_iter_mut()
                    .try_for_each_init(search, |(search, second), patch| {
                        for (y, row) in (first_row + patch.y..).zip(&mut patch.rows) {
                            if watch.cancelled() {
                                return Err(Error::Interrupted);
                            }
                            for (x, pixel) in (patch.x..).zip(row.iter_mut()) {
                                *pixel = self.trace_pixel(search, second, x, y);
                            }
                            let count = row.len() as u64;
                            let done = pixels_done.fetch_add(count, Ordering::Relaxed) + count;
                            watch.progress(done as f64 / total as f64);
                        }
                        Ok(())
                    })
            })?;
            keep_rows(first_row, &pixels);
            first_row += rows;
        }
        Ok(())
    }

    fn trace_pixel(
        &self,
        search: &mut Search<'_, R>,
        second: &mut Option<Search<'_, f64>>,
        x: u32,
        y: u32,
    ) -> Pixel {
        let (ray, hit) = search_pixel(self.flat, search, x, y);
        if let (Some(again), Some(second)) = (second, &self.second)
            && is_in_doubt(hit)
        {
            second.rays.fetch_add(1, Ordering::Relaxed);
            let (ray, hit) = search_pixel(second.flat, again, x, y);
            return shade(second.flat, ray, hit);
        }
        shade(self.flat, ray, hit)
    }
}

/// The scene in which rays in doubt are traced again.
struct Second<'a> {
    flat: &'a Flat<f64>,
    wide: Option<Wide<f64>>,
    rays: AtomicU64,
}

/// The ray of a pixel and its closest hit.
fn search_pixel<R: Real>(
    flat: &Flat<R>,
    search: &mut Search<'_, R>,
    x: u32,
    y: u32,
) -> (Ray<R>, Hit<R>) {
    let ray = camera_ray(&flat.camera, flat.size, x, y);
    let mut hit = no_hit();
    hit.tile = tile_of(flat.size, x, y);
    search.closest(probe_of(ray), &mut hit);
    (ray, hit)
}

/// A square of a band of rows, or what there is of it.
struct Patch<'p> {
    x: u32,
    /// From the band's first row.
    y: u32,
    rows: Vec<&'p mut [Pixel]>,
}

/// The patches of some rows, strip by strip.
fn patches_of(pixels: &mut [Pixel], width: usize) -> Vec<Patch<'_>> {
    let mut patches: Vec<Patch<'_>> = Vec::new();
    for (y, row) in pixels.chunks_mut(width).enumerate() {
        if y.is_multiple_of(PATCH) {
            patches.extend((0..width).step_by(PATCH).map(|x| Patch {
                x: x as u32,
                y: y as u32,
                rows: Vec::with_capacity(PATCH),
            }));
        }
        let strip = patches.len() - width.div_ceil(PATCH);
        for (patch, part) in patches[strip..].iter_mut().zip(row.chunks_mut(PATCH)) {
            patch.rows.push(part);
        }
    }
    patches
}

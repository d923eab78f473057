//! Pictures of many samples on the CPU.

use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

use rayon::ThreadPool;
use rayon::prelude::*;

use super::pool_of;
use super::search::Search;
use super::wide::Wide;
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::kernel::hit::Hit;
use crate::kernel::integrator::sample_pixel;
use crate::kernel::probe::Probe;
use crate::kernel::real::Real;
use crate::kernel::tally::add_sample;
use crate::kernel::tracer::Tracer;
use crate::layout::{Pixel, Tally};
use crate::samples::{BAND, Sampler};
use crate::watch::Watch;

impl<R: Real> Tracer<R> for Search<'_, R> {
    fn open_shutter(&mut self, time: f32) {
        self.time = time;
    }

    fn closest(&mut self, probe: Probe<R>, hit: &mut Hit<R>) {
        hit.time = self.time;
        Search::closest(self, probe, hit);
    }

    fn any(&mut self, probe: Probe<R>, limit: R) -> bool {
        Search::any(self, probe, limit)
    }
}

/// A scene and the threads that wait to take samples of it.
pub struct Sampled<'a, R> {
    flat: &'a Flat<R>,
    wide: Option<Wide<R>>,
    pool: ThreadPool,
    rows: Range<u32>,
    pixels: Vec<Pixel>,
    tallies: Vec<Tally>,
}

impl<'a, R: Real> Sampled<'a, R> {
    /// Starts `threads` threads, or one for each core, and makes the tree wide.
    ///
    /// # Errors
    ///
    /// As [`super::Prepared::new`].
    pub fn new(flat: &'a Flat<R>, threads: Option<NonZeroUsize>) -> Result<Self> {
        let pool = pool_of(threads)?;
        // The wide tree keeps its triangles where they are in the middle of the time.
        let is_wide = !flat.pairs.is_empty() && !flat.has_moving_shapes();
        let wide = is_wide.then(|| pool.install(|| Wide::new(flat)));
        Ok(Self {
            flat,
            wide,
            pool,
            rows: 0..0,
            pixels: Vec::new(),
            tallies: Vec::new(),
        })
    }
}

impl<R: Real> Sampler for Sampled<'_, R> {
    fn max_rows(&self) -> u32 {
        (BAND / self.flat.size[0]).max(1)
    }

    fn start(&mut self, rows: Range<u32>) {
        let pixels = rows.len() * self.flat.size[0] as usize;
        self.rows = rows;
        self.pixels = vec![Pixel::default(); pixels];
        self.tallies = vec![Tally::default(); pixels];
    }

    fn take(
        &mut self,
        sample: u32,
        watch: &dyn Watch,
        progress: &(dyn Fn(f64) + Sync),
    ) -> Result<()> {
        let (flat, wide) = (self.flat, self.wide.as_ref());
        let rows = self.rows.len() as f64;
        let width = flat.size[0] as usize;
        let take_row = |search: &mut Search<'_, R>, y: u32, row: (&mut [Pixel], &mut [Tally])| {
            for ((x, sum), tally) in (0..).zip(row.0).zip(row.1) {
                let taken = sample_pixel(flat, search, x, y, sample);
                if sample == 0 {
                    *sum = Pixel {
                        color: [0.0; 3],
                        ..taken
                    };
                }
                add_sample(sum, tally, taken.color.into());
            }
        };
        let rows_done = AtomicU32::new(0);
        let pixels = self.pixels.par_chunks_mut(width);
        let rows_of_sums = pixels.zip(self.tallies.par_chunks_mut(width));
        self.pool.install(|| {
            rows_of_sums.zip(self.rows.clone()).try_for_each_init(
                || Search::new(flat, wide),
                |search, (row, y)| {
                    if watch.cancelled() {
                        return Err(Error::Interrupted);
                    }
                    take_row(search, y, row);
                    let done = rows_done.fetch_add(1, Ordering::Relaxed) + 1;
                    progress(f64::from(done) / rows);
                    Ok(())
                },
            )
        })
    }

    fn look(&mut self, see: &mut dyn FnMut(&[Pixel], &[Tally])) -> Result<()> {
        see(&self.pixels, &self.tallies);
        Ok(())
    }
}

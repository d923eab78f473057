//! Pictures of many samples: taken one after the other, added up, until there are enough.

use std::ops::Range;
use std::time::{Duration, Instant};

use crate::error::Result;
use crate::frame::Frame;
use crate::kernel::tally::luminance;
use crate::layout::{Pixel, Tally};
use crate::watch::Watch;

/// Takes samples of some rows of a picture, and adds them up.
pub trait Sampler {
    /// How many rows it holds at most.
    fn max_rows(&self) -> u32;

    /// Begins with other rows.
    fn start(&mut self, rows: Range<u32>);

    /// Adds a sample of each pixel; `progress` is called with the part that is done.
    ///
    /// # Errors
    ///
    /// [`crate::Error::DeviceLost`], [`crate::Error::Interrupted`] when `watch` says so.
    fn take(
        &mut self,
        sample: u32,
        watch: &dyn Watch,
        progress: &(dyn Fn(f64) + Sync),
    ) -> Result<()>;

    /// Shows the sums of the samples so far, and what is kept besides.
    ///
    /// # Errors
    ///
    /// [`crate::Error::DeviceLost`].
    fn look(&mut self, see: &mut dyn FnMut(&[Pixel], &[Tally])) -> Result<()>;
}

/// When a picture has enough samples.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Enough {
    /// After so long.
    pub time: Option<Duration>,
    /// When the noise is estimated to be no more than this, see [`Taken::noise`].
    pub noise: Option<f64>,
}

/// Shows a picture on its way.
pub struct Preview<'a> {
    /// How often.
    pub every: Duration,
    /// Called with the picture so far, and how many samples it has.
    pub show: &'a mut dyn FnMut(&Frame, u32) -> Result<()>,
}

impl Preview<'_> {
    /// The same, for a while.
    pub fn again(&mut self) -> Preview<'_> {
        Preview {
            every: self.every,
            show: &mut *self.show,
        }
    }
}

/// What was taken for a picture.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Taken {
    /// Samples of each pixel; the fewest, where not all have as many.
    pub samples: u32,
    /// The estimated error: the root of the mean square of the pixels' standard errors, in
    /// parts of the picture's mean luminance. None of fewer than two samples.
    pub noise: Option<f64>,
    /// Samples that were no numbers, or that took more steps than a driver allows, and are left
    /// out.
    pub faults: u64,
    /// The first pixel that has one.
    pub first_fault: Option<[u32; 2]>,
}

/// Pixels of a band at most: their sums fit the 128 MiB that a software driver binds. The same
/// on every backend, for the noise is looked at band by band.
pub const BAND: u32 = 1 << 21;

/// After so many samples, and each time so many more, the noise is looked at.
const LOOK_EVERY: u32 = 16;

/// Takes at most `samples` samples of each pixel of `frame`.
///
/// # Errors
///
/// As [`Sampler::take`] and `preview`.
pub fn take_samples(
    sampler: &mut dyn Sampler,
    frame: &mut Frame,
    samples: u32,
    enough: Enough,
    watch: &dyn Watch,
    mut preview: Option<Preview<'_>>,
) -> Result<Taken> {
    let height = frame.height;
    let most = sampler.max_rows().min(height);
    let mut picture = Sums::default();
    let mut fewest = samples;
    let started = Instant::now();
    let mut first_row = 0;
    while first_row < height {
        let rows = first_row..height.min(first_row + most);
        let before = f64::from(first_row) / f64::from(height);
        let part = f64::from(rows.len() as u32) / f64::from(height);
        // Rows that come later are due as much time each.
        let time = enough.time.map(|time| time.mul_f64(before + part));
        sampler.start(rows.clone());
        let mut shown = Instant::now();
        let mut taken = 0;
        while taken < samples {
            let done = |done: f64| {
                let of_samples = (f64::from(taken) + done) / f64::from(samples);
                let of_time = time.map_or(0.0, |time| {
                    started.elapsed().as_secs_f64() / time.as_secs_f64().max(1e-9)
                });
                watch.progress(before + part * of_samples.max(of_time).min(1.0));
            };
            sampler.take(taken, watch, &done)?;
            taken += 1;
            if time.is_some_and(|time| started.elapsed() >= time) {
                break;
            }
            if let Some(noise) = enough.noise
                && taken.is_multiple_of(LOOK_EVERY)
            {
                let mut sums = Sums::default();
                sampler.look(&mut |pixels, tallies| {
                    sums.add(pixels, tallies, taken, frame.width, 0)
                })?;
                if sums.noise().is_some_and(|found| found <= noise) {
                    break;
                }
            }
            if let Some(preview) = &mut preview
                && taken < samples
                && shown.elapsed() >= preview.every
            {
                sampler.look(&mut |pixels, tallies| {
                    keep_means(frame, rows.start, pixels, tallies, taken);
                })?;
                (preview.show)(frame, taken)?;
                shown = Instant::now();
            }
        }
        sampler.look(&mut |pixels, tallies| {
            picture.add(pixels, tallies, taken, frame.width, rows.start);
            keep_means(frame, rows.start, pixels, tallies, taken);
        })?;
        fewest = fewest.min(taken);
        first_row = rows.end;
    }
    Ok(Taken {
        samples: fewest,
        noise: picture.noise(),
        faults: picture.faults,
        first_fault: picture.first_fault,
    })
}

/// Divides sums by the number of samples, and keeps them in the frame.
fn keep_means(frame: &mut Frame, first_row: u32, pixels: &[Pixel], tallies: &[Tally], taken: u32) {
    let means: Vec<Pixel> = pixels
        .iter()
        .zip(tallies)
        .map(|(pixel, tally)| Pixel {
            color: mean(pixel.color, taken - tally.faults),
            ..*pixel
        })
        .collect();
    // A search that was given up counts among the faults.
    let _ = frame.keep_rows(first_row, &means);
}

/// The mean of so many samples; black of none.
fn mean(sum: [f32; 3], samples: u32) -> [f32; 3] {
    if samples == 0 {
        return [0.0; 3];
    }
    sum.map(|channel| channel / samples as f32)
}

/// What is known of a picture's samples.
#[derive(Default)]
struct Sums {
    pixels: u64,
    luminance: f64,
    /// Of the means' variances.
    variance: f64,
    has_variance: bool,
    faults: u64,
    first_fault: Option<[u32; 2]>,
}

impl Sums {
    fn add(&mut self, pixels: &[Pixel], tallies: &[Tally], taken: u32, width: u32, first_row: u32) {
        for (index, (pixel, tally)) in (0..).zip(pixels.iter().zip(tallies)) {
            if tally.faults > 0 {
                self.faults += u64::from(tally.faults);
                self.first_fault
                    .get_or_insert([index % width, first_row + index / width]);
            }
            let samples = f64::from(taken - tally.faults);
            self.pixels += 1;
            if samples < 1.0 {
                continue;
            }
            let mean = f64::from(luminance(pixel.color.into())) / samples;
            self.luminance += mean;
            if samples >= 2.0 {
                self.has_variance = true;
                let square = f64::from(tally.squares) / samples;
                self.variance += (square - mean * mean).max(0.0) / (samples - 1.0);
            }
        }
    }

    fn noise(&self) -> Option<f64> {
        let pixels = self.pixels as f64;
        let noise = (self.variance / pixels).sqrt() / (self.luminance / pixels);
        (self.has_variance && noise.is_finite()).then_some(noise)
    }
}

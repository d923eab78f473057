//! Pictures that are larger than what is held at a time are made band by band.

use std::ops::Range;

use rayproof::bounds::{Bounds, bound};
use rayproof::cpu;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::gpu::{self, render::Portions};
use rayproof::layout::{Pixel, Tally};
use rayproof::samples::{Enough, Preview, Sampler, Taken, take_samples};
use rayproof::{Frame, Result, Unwatched, Watch};

use crate::common::{assert_same_bits, gpu};
use crate::scenes::room;

/// Holds fewer rows at a time than it could.
struct Narrow<'a> {
    sampler: &'a mut dyn Sampler,
    rows: u32,
    starts: Vec<Range<u32>>,
}

impl Sampler for Narrow<'_> {
    fn max_rows(&self) -> u32 {
        self.rows
    }

    fn start(&mut self, rows: Range<u32>) {
        self.starts.push(rows.clone());
        self.sampler.start(rows);
    }

    fn take(
        &mut self,
        sample: u32,
        watch: &dyn Watch,
        progress: &(dyn Fn(f64) + Sync),
    ) -> Result<()> {
        self.sampler.take(sample, watch, progress)
    }

    fn look(&mut self, see: &mut dyn FnMut(&[Pixel], &[Tally])) -> Result<()> {
        self.sampler.look(see)
    }
}

/// The picture in bands of so many rows, what was taken, and the bands.
fn in_bands(
    flat: &Flat<f32>,
    sampler: &mut dyn Sampler,
    rows: u32,
    preview: Option<Preview<'_>>,
) -> (Frame, Taken, Vec<Range<u32>>) {
    let mut frame = Frame::new(flat.size[0], flat.size[1]).unwrap();
    let mut narrow = Narrow {
        sampler,
        rows,
        starts: Vec::new(),
    };
    let (samples, enough) = (flat.samples, Enough::default());
    let taken = take_samples(
        &mut narrow,
        &mut frame,
        samples,
        enough,
        &Unwatched,
        preview,
    )
    .unwrap();
    (frame, taken, narrow.starts)
}

/// By the tree, and by lists of volumes, which are searched by other ways.
fn flats() -> [Flat<f32>; 2] {
    [Bounds::Tree, Bounds::Boxes { levels: 1 }].map(|bounds| {
        let mut flat = flatten::<f32>(&room(40, 4, 2));
        bound(&mut flat, bounds);
        flat
    })
}

fn assert_bands_do_not_show(flat: &Flat<f32>, sampler: &mut dyn Sampler) -> Frame {
    let (whole, taken, starts) = in_bands(flat, sampler, 1000, None);
    assert_eq!((starts.len(), starts[0].clone()), (1, 0..30));
    for rows in [1, 7, 8, 29, 30] {
        let (frame, taken_now, starts) = in_bands(flat, sampler, rows, None);
        assert_same_bits(&frame, &whole);
        assert_eq!(starts.len() as u32, 30u32.div_ceil(rows));
        assert_eq!(starts.last().unwrap().end, 30);
        assert_eq!(taken_now.samples, taken.samples);
        assert_eq!(taken_now.faults, taken.faults);
        // Sums of f64 in another order.
        let [one, two] = [taken.noise, taken_now.noise].map(Option::unwrap);
        assert!((one - two).abs() <= 1e-12 * one, "{one} {two}");
    }
    // Bands that are done stay while the next one is shown.
    let mut last = None;
    let mut show = |frame: &Frame, _: u32| {
        last = Some(frame.clone());
        Ok(())
    };
    let preview = Preview {
        every: std::time::Duration::ZERO,
        show: &mut show,
    };
    let (frame, ..) = in_bands(flat, sampler, 8, Some(preview));
    assert_same_bits(&frame, &whole);
    let last = last.unwrap();
    let shown = 24 * 40;
    assert_eq!(last.color[..shown], whole.color[..shown]);
    assert_ne!(last.color[shown..], whole.color[shown..]);
    whole
}

#[test]
fn bands_do_not_show_on_both_backends() {
    let gpu = gpu();
    for flat in &flats() {
        let mut here = cpu::sampled::Sampled::new(flat, None).unwrap();
        let mut there = gpu::sampled::Sampled::new(&gpu, flat, Portions::default()).unwrap();
        let on_cpu = assert_bands_do_not_show(flat, &mut here);
        let on_gpu = assert_bands_do_not_show(flat, &mut there);
        assert_same_bits(&on_cpu, &on_gpu);
    }
}

/// The control: rows that are taken for others.
#[test]
fn rows_that_are_mistaken_show() {
    struct Mistaken<'a>(&'a mut dyn Sampler);
    impl Sampler for Mistaken<'_> {
        fn max_rows(&self) -> u32 {
            8
        }
        fn start(&mut self, rows: Range<u32>) {
            self.0.start(0..rows.end - rows.start);
        }
        fn take(
            &mut self,
            sample: u32,
            watch: &dyn Watch,
            progress: &(dyn Fn(f64) + Sync),
        ) -> Result<()> {
            self.0.take(sample, watch, progress)
        }
        fn look(&mut self, see: &mut dyn FnMut(&[Pixel], &[Tally])) -> Result<()> {
            self.0.look(see)
        }
    }
    let flat = &flats()[0];
    let mut sampler = cpu::sampled::Sampled::new(flat, None).unwrap();
    let (whole, ..) = in_bands(flat, &mut sampler, 30, None);
    let (mistaken, ..) = in_bands(flat, &mut Mistaken(&mut sampler), 8, None);
    assert!(!mistaken.has_bits_of(&whole));
}

//! Sends the work out: tiles of rows, chunks of primitives.
//!
//! A dispatch is small on purpose. It keeps clear of the watchdog that ends long
//! dispatches on desktop GPUs, and of the 65,535 loop iterations after which
//! lavapipe silently stops an invocation; it lets progress show and a render be
//! cancelled.

use std::ops::Range;
use std::time::{Duration, Instant};

use super::device::{Gpu, Kernel};
use super::program::Program;
use super::stage::Stage;
use crate::effects::shader_files;
use crate::error::{Error, Result};
use crate::flatten::Flat;
use crate::layout::{CornerNormals, Disk, Dispatch, Pixel, Plane, Run, Sphere, Triangle};
use crate::watch::Watch;

/// Primitives that one dispatch tests at most: below the 65,535 loop iterations
/// that lavapipe allows an invocation, with room for the other loops.
pub const PRIMITIVES_PER_DISPATCH: u32 = 60_000;

/// How long a dispatch should take: long enough that starting it costs little,
/// short enough to be smooth and far from any watchdog.
const DISPATCH_TIME: Duration = Duration::from_millis(75);

/// Shape tests a second before anything was measured: slow software.
const FIRST_GUESS: f64 = 1e7;

/// Renders a flattened scene. The rows of pixels are handed to `keep_rows`, from
/// top to bottom, together with the number of their first row.
///
/// # Errors
///
/// [`Error::Limit`] when the scene does not fit the device, [`Error::DeviceLost`]
/// when the device is lost or did not do all the tests, [`Error::Interrupted`]
/// when `watch` says so.
pub fn render(
    gpu: &Gpu,
    flat: &Flat<f32>,
    watch: &dyn Watch,
    keep_rows: &mut dyn FnMut(u32, &[Pixel]),
) -> Result<()> {
    let program = Program::build(&shader_files(flat, gpu.arithmetic.divide_file()))?;
    let kernel = gpu.compile(&program)?;
    let windows = windows(flat, gpu.limits.max_storage_buffer_binding_size);
    let stage = Stage::set_up(gpu, flat, &kernel, &windows)?;
    let mut pace = Pace::new(flat);
    let mut row = 0;
    while row < flat.size[1] {
        let rows = pace.rows(flat, stage.max_rows).min(flat.size[1] - row);
        let tile = Tile {
            first_row: row,
            rows,
        };
        for (index, window) in windows.iter().enumerate() {
            trace_window(
                gpu, flat, &kernel, &stage, index, window, tile, &mut pace, watch,
            )?;
        }
        for (index, window) in windows.iter().enumerate() {
            let dispatch = dispatch_of(flat, window, window.clone(), tile, false);
            stage.dispatch(gpu, &kernel, "shade_tile", index, &dispatch)?;
        }
        let pixels = stage.read_pixels(gpu, flat.size[0] * rows)?;
        check_tests(&pixels, flat.primitives())?;
        keep_rows(row, &pixels);
        row += rows;
    }
    Ok(())
}

/// A band of rows.
#[derive(Debug, Clone, Copy)]
struct Tile {
    first_row: u32,
    rows: u32,
}

/// The closest hits of a tile among the primitives of a window.
#[expect(
    clippy::too_many_arguments,
    reason = "the loop's whole state, each named"
)]
fn trace_window(
    gpu: &Gpu,
    flat: &Flat<f32>,
    kernel: &Kernel,
    stage: &Stage,
    index: usize,
    window: &Range<u32>,
    tile: Tile,
    pace: &mut Pace,
    watch: &dyn Watch,
) -> Result<()> {
    let mut begin = window.start;
    loop {
        if watch.cancelled() {
            return Err(Error::Interrupted);
        }
        let pixels = flat.size[0] * tile.rows;
        let end = window.end.min(begin.saturating_add(pace.chunk(pixels)));
        let dispatch = dispatch_of(flat, window, begin..end, tile, begin == 0);
        let started = Instant::now();
        stage.dispatch(gpu, kernel, "trace_tile", index, &dispatch)?;
        pace.learn(pixels, end - begin, started.elapsed());
        watch.progress(pace.done());
        begin = end;
        if begin >= window.end {
            return Ok(());
        }
    }
}

/// Every pixel must have tested every primitive; a driver that stops a loop
/// early says nothing else.
fn check_tests(pixels: &[Pixel], expected: u32) -> Result<()> {
    match pixels.iter().find(|pixel| pixel.tests != expected) {
        None => Ok(()),
        Some(pixel) => Err(Error::DeviceLost(format!(
            "the driver stopped an invocation after {} of {expected} shape tests without a word",
            pixel.tests
        ))),
    }
}

/// The primitive ids of each set of buffers: consecutive ones, as many as a
/// binding holds.
pub fn windows<R>(flat: &Flat<R>, binding_bytes: u64) -> Vec<Range<u32>> {
    let kinds = [
        (
            flat.first_sphere(),
            flat.spheres.len(),
            size_of::<Sphere<R>>(),
        ),
        (flat.first_plane(), flat.planes.len(), size_of::<Plane<R>>()),
        (flat.first_disk(), flat.disks.len(), size_of::<Disk<R>>()),
        (
            flat.first_triangle(),
            flat.triangles.len(),
            size_of::<Triangle<R>>().max(size_of::<CornerNormals>()),
        ),
    ];
    let mut windows = Vec::new();
    let mut begin = 0;
    while begin < flat.primitives() {
        let mut end = begin;
        for (first, count, stride) in kinds {
            let last = first + count as u32;
            let room = u32::try_from(binding_bytes / stride as u64).unwrap_or(u32::MAX);
            // A kind that does not end in this window is the window's last.
            if end < last {
                end = last.min(end.saturating_add(room));
                if end < last {
                    break;
                }
            }
        }
        windows.push(begin..end);
        begin = end;
    }
    if windows.is_empty() {
        windows.push(0..0);
    }
    windows
}

/// The part of `ids` that lies in a kind with `count` primitives from `first`,
/// as indices into the kind's array.
pub(super) fn part(ids: &Range<u32>, first: u32, count: usize) -> Range<u32> {
    let last = first + count as u32;
    ids.start.clamp(first, last) - first..ids.end.clamp(first, last) - first
}

/// The orders for one dispatch: test `chunk` of the ids of `window`.
fn dispatch_of(
    flat: &Flat<f32>,
    window: &Range<u32>,
    chunk: Range<u32>,
    tile: Tile,
    fresh: bool,
) -> Dispatch {
    let run = |first: u32, count: usize| {
        let bound = part(window, first, count);
        let tested = part(&chunk, first, count);
        Run {
            begin: tested.start - bound.start,
            end: tested.end - bound.start,
            first_id: first + bound.start,
            padding: 0,
        }
    };
    Dispatch {
        size: flat.size,
        first_row: tile.first_row,
        rows: tile.rows,
        spheres: run(flat.first_sphere(), flat.spheres.len()),
        planes: run(flat.first_plane(), flat.planes.len()),
        disks: run(flat.first_disk(), flat.disks.len()),
        triangles: run(flat.first_triangle(), flat.triangles.len()),
        first_id: window.start,
        primitives: window.end - window.start,
        fresh: u32::from(fresh),
        padding: 0,
    }
}

/// How much work a dispatch gets, learnt from how long the last ones took.
struct Pace {
    /// Shape tests a second.
    rate: f64,
    total: f64,
    tested: f64,
}

impl Pace {
    fn new(flat: &Flat<f32>) -> Self {
        let pixels = f64::from(flat.size[0]) * f64::from(flat.size[1]);
        let total = pixels * f64::from(flat.primitives().max(1));
        Self {
            rate: FIRST_GUESS,
            total,
            tested: 0.0,
        }
    }

    /// Tests that a dispatch should hold.
    fn budget(&self) -> f64 {
        self.rate * DISPATCH_TIME.as_secs_f64()
    }

    /// Rows of the next tile. A whole workgroup is 8 rows high.
    fn rows(&self, flat: &Flat<f32>, max_rows: u32) -> u32 {
        let primitives = flat.primitives().clamp(1, PRIMITIVES_PER_DISPATCH);
        let row = f64::from(flat.size[0]) * f64::from(primitives);
        let rows = (self.budget() / row) as u32;
        (rows / 8 * 8).max(8).min(max_rows)
    }

    /// Primitives of the next dispatch over this many pixels.
    fn chunk(&self, pixels: u32) -> u32 {
        let primitives = self.budget() / f64::from(pixels);
        (primitives as u32).clamp(256, PRIMITIVES_PER_DISPATCH)
    }

    /// Takes a finished dispatch into account. The first one of a kernel may
    /// hold the driver's compiling, so the rate may only quadruple at a time.
    fn learn(&mut self, pixels: u32, primitives: u32, took: Duration) {
        let tests = f64::from(pixels) * f64::from(primitives.max(1));
        let rate = tests / took.as_secs_f64().max(1e-6);
        self.rate = rate.clamp(self.rate / 4.0, self.rate * 4.0);
        self.tested += tests;
    }

    fn done(&self) -> f64 {
        (self.tested / self.total).min(1.0)
    }
}

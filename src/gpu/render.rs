//! Sends the work out: tiles of rows, chunks of primitives.
//!
//! A dispatch is small on purpose. It keeps clear of the watchdog that ends long
//! dispatches on desktop GPUs, and of the 65,535 loop iterations after which
//! lavapipe silently stops an invocation; it lets progress show and a render be
//! cancelled.

use std::time::Instant;

use super::device::Gpu;
use super::kernel::Kernel;
use super::pace::Pace;
use super::program::Program;
use super::stage::Stage;
use super::window::{Tile, Window};
use crate::effects::shader_files;
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::layout::Pixel;
use crate::watch::Watch;

/// Primitives that one dispatch tests at most: below the 65,535 loop iterations
/// that lavapipe allows an invocation, with room for the other loops.
const PRIMITIVES_PER_DISPATCH: u32 = 60_000;

/// How much goes into one dispatch and into one buffer at most.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Portions {
    /// Primitives that one dispatch tests.
    pub primitives_per_dispatch: u32,
    /// Bytes of one buffer of primitives.
    pub binding_bytes: u64,
}

impl Portions {
    /// What a device takes.
    pub fn of(gpu: &Gpu) -> Self {
        let limits = &gpu.limits;
        Self {
            primitives_per_dispatch: PRIMITIVES_PER_DISPATCH,
            binding_bytes: limits
                .max_storage_buffer_binding_size
                .min(limits.max_buffer_size),
        }
    }
}

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
    portions: Portions,
    watch: &dyn Watch,
    keep_rows: &mut dyn FnMut(u32, &[Pixel]),
) -> Result<()> {
    // A tree leads anywhere, so all that it leads to must be bound at once.
    let plain;
    let flat = if flat.pairs.is_empty() || flat.largest_array() <= portions.binding_bytes {
        flat
    } else {
        tracing::warn!(
            "the scene needs {} bytes in one buffer, more than the {} that this device binds: \
             tracing without volumes",
            flat.largest_array(),
            portions.binding_bytes
        );
        plain = Flat {
            pairs: Vec::new(),
            leaf_ids: Vec::new(),
            ..flat.clone()
        };
        &plain
    };
    let program = Program::build(&shader_files(&flat.counts(), gpu.arithmetic.divide_file()))?;
    let kernel = gpu.compile(&program)?;
    let windows = Window::split(flat, portions.binding_bytes);
    let stage = Stage::set_up(gpu, flat, &kernel, &windows)?;
    let work = Work {
        gpu,
        flat,
        kernel,
        windows,
        stage,
    };
    let mut pace = Pace::new(
        flat.size,
        flat.primitives(),
        flat.lights.len() as u32,
        portions.primitives_per_dispatch,
    );
    let mut first_row = 0;
    while first_row < flat.size[1] {
        let rows = pace.rows(work.stage.max_rows).min(flat.size[1] - first_row);
        let pixels = work.trace(Tile { first_row, rows }, &mut pace, watch)?;
        if flat.pairs.is_empty() {
            check_tests(&pixels, flat.primitives())?;
        }
        keep_rows(first_row, &pixels);
        first_row += rows;
    }
    Ok(())
}

/// A scene on a device, ready to be traced.
struct Work<'a> {
    gpu: &'a Gpu,
    flat: &'a Flat<f32>,
    kernel: Kernel,
    windows: Vec<Window>,
    stage: Stage,
}

impl Work<'_> {
    /// The pixels of a tile: its closest hits, window after window, then their
    /// colours, window after window.
    fn trace(&self, tile: Tile, pace: &mut Pace, watch: &dyn Watch) -> Result<Vec<Pixel>> {
        for index in 0..self.windows.len() {
            self.trace_window(index, tile, pace, watch)?;
        }
        for (index, window) in self.windows.iter().enumerate() {
            let orders = window.orders(self.flat, window.ids.clone(), tile);
            self.stage
                .dispatch(self.gpu, &self.kernel, "shade_tile", index, &orders)?;
        }
        self.stage
            .read_pixels(self.gpu, self.flat.size[0] * tile.rows)
    }

    /// Brings the tile's closest hits up to date with the primitives of a window.
    /// An empty window gets one dispatch too, which notes that nothing is hit.
    fn trace_window(
        &self,
        index: usize,
        tile: Tile,
        pace: &mut Pace,
        watch: &dyn Watch,
    ) -> Result<()> {
        let window = &self.windows[index];
        let pixels = self.flat.size[0] * tile.rows;
        let mut begin = window.ids.start;
        loop {
            if watch.cancelled() {
                return Err(Error::Interrupted);
            }
            let end = if self.flat.pairs.is_empty() {
                window.ids.end.min(begin.saturating_add(pace.chunk(pixels)))
            } else {
                window.ids.end
            };
            let orders = window.orders(self.flat, begin..end, tile);
            let started = Instant::now();
            self.stage
                .dispatch(self.gpu, &self.kernel, "trace_tile", index, &orders)?;
            let tested = if self.flat.pairs.is_empty() {
                end - begin
            } else {
                1
            };
            pace.learn(pixels, tested, started.elapsed());
            watch.progress(pace.done());
            begin = end;
            if begin >= window.ids.end {
                return Ok(());
            }
        }
    }
}

/// Every pixel must have tested every primitive: a driver that stops a loop
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

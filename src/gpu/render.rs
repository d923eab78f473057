//! Sends the work out: tiles of rows, chunks of primitives.
//!
//! A dispatch is small on purpose. It keeps clear of the watchdog that ends long
//! dispatches on desktop GPUs, and of the 65,535 loop iterations after which
//! lavapipe silently stops an invocation; it lets progress show and a render be
//! cancelled.

use std::borrow::Cow;
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

/// What a ray through a tree counts for, in shape tests: some pairs of boxes and
/// some shapes. The first dispatch is sized by it, the others by what they take.
const TREE_TESTS: u32 = 32;

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

/// Renders a flattened scene, once: [`Prepared::new`], then [`Prepared::run`].
///
/// # Errors
///
/// As those two.
pub fn render(
    gpu: &Gpu,
    flat: &Flat<f32>,
    portions: Portions,
    watch: &dyn Watch,
    keep_rows: &mut dyn FnMut(u32, &[Pixel]),
) -> Result<()> {
    Prepared::new(gpu, flat, portions)?.run(watch, keep_rows)
}

/// A scene on a device, uploaded and its shaders compiled: ready to be traced,
/// any number of times.
pub struct Prepared<'a> {
    gpu: &'a Gpu,
    flat: Cow<'a, Flat<f32>>,
    kernel: Kernel,
    windows: Vec<Window>,
    stage: Stage,
    pace: Pace,
}

impl<'a> Prepared<'a> {
    /// Uploads a flattened scene and compiles the shaders that it calls for. A
    /// tree that does not fit the device is left out, with a warning.
    ///
    /// # Errors
    ///
    /// [`Error::Limit`] when the scene does not fit the device,
    /// [`Error::Shader`] when the driver refuses a shader.
    pub fn new(gpu: &'a Gpu, flat: &'a Flat<f32>, portions: Portions) -> Result<Self> {
        let flat = bindable(flat, portions.binding_bytes);
        let program = Program::build(&shader_files(&flat.counts(), gpu.arithmetic.divide_file()))?;
        let kernel = gpu.compile(&program)?;
        let windows = Window::split(&flat, portions.binding_bytes);
        let stage = Stage::set_up(gpu, &flat, &kernel, &windows)?;
        let pace = Pace::new(
            flat.size,
            tests_per_ray(&flat),
            flat.lights.len() as u32,
            portions.primitives_per_dispatch,
        );
        Ok(Self {
            gpu,
            flat,
            kernel,
            windows,
            stage,
            pace,
        })
    }

    /// Whether rays go through a tree: one was built, and it fits the device.
    pub fn has_tree(&self) -> bool {
        !self.flat.pairs.is_empty()
    }

    /// Traces all pixels. Their rows are handed to `keep_rows`, from top to
    /// bottom, together with the number of their first row. What a run learns of
    /// the device's pace, the next one starts from.
    ///
    /// # Errors
    ///
    /// [`Error::DeviceLost`] when the device is lost or did not do all the tests,
    /// [`Error::Interrupted`] when `watch` says so.
    pub fn run(
        &mut self,
        watch: &dyn Watch,
        keep_rows: &mut dyn FnMut(u32, &[Pixel]),
    ) -> Result<()> {
        self.pace.start_anew();
        let height = self.flat.size[1];
        let mut first_row = 0;
        while first_row < height {
            let rows = self.pace.rows(self.stage.max_rows).min(height - first_row);
            let pixels = self.trace(Tile { first_row, rows }, watch)?;
            if !self.has_tree() {
                check_tests(&pixels, self.flat.primitives())?;
            }
            keep_rows(first_row, &pixels);
            first_row += rows;
        }
        Ok(())
    }

    /// The pixels of a tile: its closest hits, window after window, then their
    /// colours, window after window.
    fn trace(&mut self, tile: Tile, watch: &dyn Watch) -> Result<Vec<Pixel>> {
        for index in 0..self.windows.len() {
            self.trace_window(index, tile, watch)?;
        }
        for (index, window) in self.windows.iter().enumerate() {
            let orders = window.orders(&self.flat, window.ids.clone(), tile);
            self.stage
                .dispatch(self.gpu, &self.kernel, "shade_tile", index, &orders)?;
        }
        self.stage
            .read_pixels(self.gpu, self.flat.size[0] * tile.rows)
    }

    /// Brings the tile's closest hits up to date with the primitives of a window.
    /// An empty window gets one dispatch too, which notes that nothing is hit.
    fn trace_window(&mut self, index: usize, tile: Tile, watch: &dyn Watch) -> Result<()> {
        let window = &self.windows[index];
        let pixels = self.flat.size[0] * tile.rows;
        let mut begin = window.ids.start;
        loop {
            if watch.cancelled() {
                return Err(Error::Interrupted);
            }
            let (end, tested) = if self.has_tree() {
                (window.ids.end, tests_per_ray(&self.flat))
            } else {
                let chunk = self.pace.chunk(pixels);
                let end = window.ids.end.min(begin.saturating_add(chunk));
                (end, end - begin)
            };
            let orders = window.orders(&self.flat, begin..end, tile);
            let started = Instant::now();
            self.stage
                .dispatch(self.gpu, &self.kernel, "trace_tile", index, &orders)?;
            self.pace.learn(pixels, tested, started.elapsed());
            watch.progress(self.pace.done());
            begin = end;
            if begin >= window.ids.end {
                return Ok(());
            }
        }
    }
}

/// The scene, without its tree where one buffer cannot hold what it leads to: a
/// tree leads anywhere, so all of it must be bound at once.
fn bindable(flat: &Flat<f32>, binding_bytes: u64) -> Cow<'_, Flat<f32>> {
    if flat.pairs.is_empty() || flat.largest_array() <= binding_bytes {
        return Cow::Borrowed(flat);
    }
    tracing::warn!(
        "the scene needs {} bytes in one buffer, more than the {binding_bytes} that this device \
         binds: tracing without volumes",
        flat.largest_array(),
    );
    Cow::Owned(Flat {
        pairs: Vec::new(),
        leaf_ids: Vec::new(),
        ..flat.clone()
    })
}

/// Shape tests of one ray, as far as the pace is concerned.
fn tests_per_ray(flat: &Flat<f32>) -> u32 {
    if flat.pairs.is_empty() {
        flat.primitives()
    } else {
        TREE_TESTS.min(flat.primitives())
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

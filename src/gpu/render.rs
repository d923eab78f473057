//! Sends the work out: tiles of rows, chunks of primitives.
//!
//! A dispatch is small on purpose. It keeps clear of the watchdog that ends long
//! dispatches on desktop GPUs, and of the 65,535 loop iterations after which
//! lavapipe silently stops an invocation; it lets progress show and a render be
//! cancelled.

use std::time::Instant;

use super::device::Gpu;
use super::kernel::Kernel;
use super::loaded::Loaded;
use super::pace::Pace;
pub use super::portions::{Portions, Seconds};
use super::program::Source;
use super::retrace::Retrace;
use super::screen::Screen;
use super::stage::Stage;
use super::tile::Tile;
use crate::count::{CountMap, Counted};
use crate::effects::{Entry, Fetch};
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::kernel::real::Real;
use crate::layout::{Dispatch, Pixel};
use crate::tier::{Bounded, Double};
use crate::watch::Watch;

/// Lights that may be looped over in the dispatch of a search: with them it stays within
/// the 65,535 loop iterations that lavapipe allows an invocation.
const FEW_LIGHTS: usize = 1000;

/// What a ray through a tree counts for, in shape tests: some pairs of boxes and
/// some shapes. The first dispatch is sized by it, the others by what they take.
const TREE_TESTS: u32 = 32;

/// Renders a flattened scene, once: [`Prepared::new`], then [`Prepared::run`].
///
/// # Errors
///
/// As those two.
pub fn render<R: Real>(
    gpu: &Gpu,
    flat: &Flat<R>,
    portions: Portions,
    watch: &dyn Watch,
    keep_rows: &mut dyn FnMut(u32, &[Pixel]),
) -> Result<()> {
    Prepared::new(gpu, flat, portions)?.run(watch, keep_rows)
}

/// A scene in f32 ready to be traced with bounds of the error, and in f64 for the rays in
/// doubt, or in two f32 where the device has no f64: the same volumes in both.
///
/// # Errors
///
/// As [`Prepared::new`] and [`Prepared::with_second`].
pub fn adaptive<'a>(
    gpu: &'a Gpu,
    first: &'a Flat<Bounded>,
    second: &Flat<Double>,
    portions: Portions,
) -> Result<Prepared<'a, Bounded>> {
    Prepared::new(gpu, first, portions)?.with_second(second, portions)
}

/// Whether one dispatch can test all that a ray may meet.
pub(super) fn searches_at_once<R>(flat: &Flat<R>, portions: Portions) -> bool {
    let tests = flat.primitives() + flat.volumes.len() as u32;
    !flat.pairs.is_empty() || tests <= portions.primitives_per_dispatch
}

/// Whether one dispatch can search and colour, so that pixels in doubt can be traced again.
pub fn may_retrace<R>(flat: &Flat<R>, portions: Portions) -> bool {
    searches_at_once(flat, portions) && flat.lights.len() <= FEW_LIGHTS
}

/// Counts what each ray of a picture tests, with shaders that count.
///
/// # Errors
///
/// As [`render`].
pub fn count<R: Real>(gpu: &Gpu, flat: &Flat<R>, watch: &dyn Watch) -> Result<CountMap> {
    let portions = Portions {
        count: true,
        ..Portions::default()
    };
    let mut prepared = Prepared::new(gpu, flat, portions)?;
    prepared.run(watch, &mut |_, _| {})?;
    Ok(CountMap {
        width: flat.size[0],
        pixels: prepared.counted,
    })
}

/// A scene on a device, uploaded and its shaders compiled: ready to be traced,
/// any number of times.
pub struct Prepared<'a, R> {
    gpu: &'a Gpu,
    flat: &'a Flat<R>,
    fetch: Fetch,
    kernel: Kernel,
    stage: Stage,
    screen: Screen,
    retrace: Option<Retrace>,
    pace: Pace,
    /// Pixel by pixel, where that is counted.
    counted: Vec<Counted>,
    count: bool,
    seconds: Option<Seconds>,
}

impl<'a, R: Real> Prepared<'a, R> {
    /// Uploads a flattened scene and compiles the shaders that it calls for.
    ///
    /// # Errors
    ///
    /// [`Error::Limit`] when the scene does not fit the device,
    /// [`Error::Shader`] when the driver refuses a shader.
    pub fn new(gpu: &'a Gpu, flat: &'a Flat<R>, portions: Portions) -> Result<Self> {
        Self::changed(gpu, flat, portions, &|_| {})
    }

    /// As [`Prepared::new`], with shader files that `change` may change first.
    pub(super) fn changed(
        gpu: &'a Gpu,
        flat: &'a Flat<R>,
        portions: Portions,
        change: &dyn Fn(&mut Vec<Source>),
    ) -> Result<Self> {
        let loaded = Loaded::new(gpu, flat, Entry::Tile, portions, change)?;
        let screen = Screen::set_up(gpu, flat)?;
        let stage = Stage::set_up(gpu, flat, &loaded, &screen, portions)?;
        let pace = Pace::new(
            flat.size,
            tests_per_ray(flat),
            flat.lights.len() as u32,
            portions.primitives_per_dispatch,
        );
        Ok(Self {
            gpu,
            flat,
            fetch: loaded.fetch,
            kernel: loaded.kernel,
            seconds: stage.has_clock().then(Seconds::default),
            stage,
            screen,
            retrace: None,
            pace,
            counted: Vec::new(),
            count: portions.count,
        })
    }

    /// Has the rays that are in doubt traced again in wider numbers: `second` is the same
    /// scene with the same volumes.
    ///
    /// # Errors
    ///
    /// As [`Prepared::new`]; [`Error::Limit`] where one dispatch cannot test everything.
    pub fn with_second(mut self, second: &Flat<Double>, portions: Portions) -> Result<Self> {
        let retrace = Retrace::set_up(
            self.gpu,
            second,
            Entry::DoubtfulPixels,
            &[
                ("doubtful", &self.stage.doubtful),
                ("pixels", &self.stage.pixels),
                ("masks", &self.screen.masks),
                ("split", &self.screen.split),
            ],
            portions,
        )?;
        self.retrace = Some(retrace);
        Ok(self)
    }

    /// How many rays of the last picture were traced again.
    pub fn retraced(&self) -> u64 {
        self.retrace.as_ref().map_or(0, Retrace::rays)
    }

    /// Where the scene lies on the device.
    pub fn fetch(&self) -> Fetch {
        self.fetch
    }

    /// How long the last run's passes took, where that is timed and the device has a
    /// clock.
    pub fn seconds(&self) -> Option<Seconds> {
        self.seconds
    }

    fn has_tree(&self) -> bool {
        !self.flat.pairs.is_empty()
    }

    fn has_volumes(&self) -> bool {
        self.has_tree() || !self.flat.volumes.is_empty()
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
        if let Some(retrace) = &mut self.retrace {
            retrace.start_anew();
        }
        let pixels = self.flat.size[0] as usize * self.flat.size[1] as usize;
        let mut counted = Vec::with_capacity(if self.count { pixels } else { 0 });
        let mut seconds = Seconds::default();
        seconds.trace +=
            self.screen
                .divide(self.gpu, &self.kernel, &self.stage, self.flat, watch)?;
        let height = self.flat.size[1];
        let mut first_row = 0;
        while first_row < height {
            let rows = self.pace.rows(self.stage.max_rows).min(height - first_row);
            let tile = Tile {
                first_row,
                rows,
                spread: self.gpu.adapter.is_software(),
            };
            let traced = self.trace(tile, watch)?;
            seconds.trace += traced.seconds;
            if !traced.is_shaded {
                let orders = tile.orders(self.flat, 0..0);
                seconds.shade += self.dispatch("shade_tile", tile, &orders)?;
            }
            if let Some(retrace) = &mut self.retrace {
                let orders = tile.all_orders(self.flat);
                let (list, clock) = (&self.stage.doubtful, self.stage.clock());
                seconds.trace += retrace.run(self.gpu, list, &orders, clock, watch)?;
            }
            let mut checked = Ok(());
            let mut tests = Vec::new();
            let pixels = self.flat.size[0] * rows;
            self.stage.look_at_pixels(self.gpu, pixels, &mut |pixels| {
                if !self.has_volumes() {
                    checked = check_tests(pixels, self.flat.primitives());
                }
                if checked.is_ok() {
                    keep_rows(first_row, pixels);
                }
                if self.count {
                    tests.extend(pixels.iter().map(|pixel| pixel.tests));
                }
            })?;
            checked?;
            if self.count {
                let counts = self.stage.read_counts(self.gpu, pixels)?;
                for ([tested, met], tests) in counts.into_iter().zip(tests) {
                    counted.push(Counted::of(tested, met, tests)?);
                }
            }
            first_row += rows;
        }
        self.counted = counted;
        self.seconds = self.seconds.map(|_| seconds);
        Ok(())
    }

    fn dispatch(&self, entry: &str, tile: Tile, orders: &Dispatch) -> Result<f64> {
        let workgroups = tile.workgroups(orders);
        self.stage
            .dispatch(self.gpu, &self.kernel, entry, workgroups, orders)
    }

    /// Finds the tile's closest hits: through the tree in one dispatch, else by one
    /// for each run of primitives, or of entries and primitives of the list of
    /// volumes. An empty scene gets one dispatch too, which notes that nothing is hit.
    /// Where one is enough, it colours them too.
    fn trace(&mut self, tile: Tile, watch: &dyn Watch) -> Result<Traced> {
        let total = tests_per_ray(self.flat);
        let pixels = self.flat.size[0] * tile.rows;
        let mut begin = 0;
        let mut seconds = 0.0;
        loop {
            if watch.cancelled() {
                return Err(Error::Interrupted);
            }
            let end = if self.has_tree() {
                total
            } else {
                total.min(begin + self.pace.chunk(pixels))
            };
            let orders = if self.has_tree() {
                tile.orders(self.flat, 0..self.flat.primitives())
            } else if self.has_volumes() {
                tile.list_orders(self.flat, begin..end, total)
            } else {
                tile.orders(self.flat, begin..end)
            };
            let at_once = begin == 0 && end >= total && self.may_shade_at_once();
            let entry = if at_once { "render_tile" } else { "trace_tile" };
            let started = Instant::now();
            seconds += self.dispatch(entry, tile, &orders)?;
            self.pace.learn(pixels, end - begin, started.elapsed());
            watch.progress(self.pace.done());
            begin = end;
            if begin >= total {
                return Ok(Traced {
                    seconds,
                    is_shaded: at_once,
                });
            }
        }
    }

    /// Whether a dispatch may search and colour: not if the passes are timed apart, and
    /// not if lights would take from the search what loops a driver allows.
    fn may_shade_at_once(&self) -> bool {
        self.seconds.is_none() && self.flat.lights.len() <= FEW_LIGHTS
    }
}

/// What became of a tile.
struct Traced {
    /// By the device's clock.
    seconds: f64,
    is_shaded: bool,
}

/// Tests of one ray at most; through a tree, as far as the pace is concerned.
fn tests_per_ray<R>(flat: &Flat<R>) -> u32 {
    if flat.pairs.is_empty() {
        flat.primitives() + flat.volumes.len() as u32
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

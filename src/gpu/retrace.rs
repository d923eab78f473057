//! The second pass of the adaptive tier: rays in doubt, once more in wider numbers.

use std::time::{Duration, Instant};

use super::device::Gpu;
use super::kernel::Kernel;
use super::loaded::Loaded;
use super::pace::DISPATCH_TIME;
use super::portions::Portions;
use super::render::{may_retrace, searches_at_once};
use super::stage::uniforms;
use super::tile::SLICES;
use super::timestamps::Clock;
use crate::effects::Entry;
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::kernel::real::Real;
use crate::layout::Dispatch;
use crate::tier::{Double, Extended};
use crate::watch::Watch;

/// Rays of a list from which on it is long: some for each core of a large device.
const LONG: u32 = 1 << 14;

/// Rays of a dispatch at least and at most.
const FEWEST: u32 = 64;
const MOST: u32 = 1 << 20;

/// Entry point for a list, and its workgroups: of 8 rays in slices, or of 64.
fn entry_for(count: u32) -> (&'static str, [u32; 3]) {
    if count < LONG {
        let across = count.div_ceil(8).div_ceil(SLICES);
        ("retrace_few", [across, 1, SLICES])
    } else {
        ("retrace", [count.div_ceil(64), 1, 1])
    }
}

/// The scene in wider numbers, and the shader that traces a list of pixels.
pub(super) struct Retrace {
    kernel: Kernel,
    frame: wgpu::BindGroup,
    scene: wgpu::BindGroup,
    dispatch: wgpu::Buffer,
    /// Where the length of the list is copied to be read; none where it is read in place.
    staging: Option<wgpu::Buffer>,
    /// Rays of the next dispatch.
    portion: u32,
    rays: u64,
}

impl Retrace {
    /// Uploads the scene. Of `shared` are the buffers of the first pass, by the names of the
    /// variables: the list of those in doubt, and where results go.
    ///
    /// # Errors
    ///
    /// As of a render; [`Error::Limit`] where one dispatch cannot test everything.
    pub(super) fn set_up(
        gpu: &Gpu,
        flat: &Flat<Double>,
        entry: Entry,
        shared: &[(&'static str, &wgpu::Buffer)],
        portions: Portions,
    ) -> Result<Self> {
        // Rays of a list are not coloured, so lights are no matter to them.
        let possible = match entry {
            Entry::DoubtfulPixels => may_retrace(flat, portions),
            _ => searches_at_once(flat, portions),
        };
        if !possible {
            return Err(Error::Limit(format!(
                "{} primitives and {} lights are more than a dispatch goes through for a ray \
                 in doubt: take bounds `tree`, or accuracy `double`",
                flat.primitives(),
                flat.lights.len()
            )));
        }
        if gpu.has_f64() {
            Self::in_numbers(gpu, flat, entry, shared, portions)
        } else {
            let flat = flat.converted::<Extended>();
            Self::in_numbers(gpu, &flat, entry, shared, portions)
        }
    }

    fn in_numbers<R: Real>(
        gpu: &Gpu,
        flat: &Flat<R>,
        entry: Entry,
        shared: &[(&'static str, &wgpu::Buffer)],
        portions: Portions,
    ) -> Result<Self> {
        let uncounted = Portions {
            count: false,
            ..portions
        };
        let loaded = Loaded::new(gpu, flat, entry, uncounted, &|_| {})?;
        let usage = wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST;
        let dispatch = gpu.create_buffer("dispatch", size_of::<Dispatch>() as u64, usage)?;
        let mut frame = uniforms(gpu, flat, &loaded.tables)?;
        frame.insert("dispatch", dispatch.clone());
        frame.extend(
            shared
                .iter()
                .map(|(name, buffer)| (*name, (*buffer).clone())),
        );
        let [frame, scene] = loaded.bind(gpu, &frame)?;
        let staged = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
        let staging = (!gpu.maps_storage()).then(|| gpu.create_buffer("doubts read", 4, staged));
        Ok(Self {
            kernel: loaded.kernel,
            frame,
            scene,
            dispatch,
            staging: staging.transpose()?,
            portion: LONG,
            rays: 0,
        })
    }

    /// Begins another picture.
    pub(super) fn start_anew(&mut self) {
        self.rays = 0;
    }

    /// How many rays of the picture were traced again.
    pub(super) fn rays(&self) -> u64 {
        self.rays
    }

    /// Traces the rays of the list, portion by portion, and empties it; gives the seconds by
    /// `clock`.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`]; [`Error::Interrupted`] when `watch` says so.
    pub(super) fn run(
        &mut self,
        gpu: &Gpu,
        doubtful: &wgpu::Buffer,
        orders: &Dispatch,
        clock: Option<&Clock>,
        watch: &dyn Watch,
    ) -> Result<f64> {
        let count = self.read_count(gpu, doubtful)?;
        self.rays += u64::from(count);
        let mut seconds = 0.0;
        let mut first = 0;
        while first < count {
            if watch.cancelled() {
                return Err(Error::Interrupted);
            }
            let portion = self.portion.min(count - first);
            let orders = Dispatch {
                first_doubtful: first,
                ..*orders
            };
            gpu.queue
                .write_buffer(&self.dispatch, 0, bytemuck::bytes_of(&orders));
            let (entry, workgroups) = entry_for(portion);
            let groups = [&self.frame, &self.scene];
            let started = Instant::now();
            seconds += self.kernel.run(gpu, entry, &groups, workgroups, clock)?;
            self.learn(portion, started.elapsed());
            first += portion;
        }
        if count > 0 {
            gpu.queue.write_buffer(doubtful, 0, &[0; 4]);
        }
        Ok(seconds)
    }

    /// Takes a finished dispatch into account: the next one of its size is to take
    /// [`DISPATCH_TIME`], and it may only quadruple, for the first may have held the
    /// driver's compiling.
    fn learn(&mut self, rays: u32, took: Duration) {
        let took = took.max(Duration::from_micros(1)).as_secs_f64();
        let wanted = f64::from(rays) * DISPATCH_TIME.as_secs_f64() / took;
        let most = f64::from(self.portion) * 4.0;
        self.portion = (wanted.min(most) as u32).clamp(FEWEST, MOST);
    }

    fn read_count(&self, gpu: &Gpu, doubtful: &wgpu::Buffer) -> Result<u32> {
        if let Some(staging) = &self.staging {
            gpu.copy(doubtful, staging, 4);
        }
        let readable = self.staging.as_ref().unwrap_or(doubtful);
        let mut count = 0;
        gpu.look_at(readable, 4, &mut |bytes| {
            count = bytemuck::pod_read_unaligned(bytes);
        })?;
        Ok(count)
    }
}

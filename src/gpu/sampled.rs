//! Pictures of many samples: one of each pixel a dispatch, tile by tile.

use std::ops::Range;
use std::time::{Duration, Instant};

use bytemuck::bytes_of;
use wgpu::BufferUsages;

use super::device::Gpu;
use super::kernel::Kernel;
use super::loaded::Loaded;
use super::pace::DISPATCH_TIME;
use super::portions::Portions;
use super::stage::uniforms;
use super::tile::{Tile, WORKGROUP};
use crate::effects::Entry;
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::kernel::real::Real;
use crate::layout::{Dispatch, Pixel, Tally};
use crate::samples::{BAND, Sampler};
use crate::watch::Watch;

/// Pixels of the first dispatch.
const FIRST_PIXELS: f64 = 16_384.0;

/// A scene on a device, and the sums of the samples that were taken of it.
pub struct Sampled<'a, R> {
    gpu: &'a Gpu,
    flat: &'a Flat<R>,
    kernel: Kernel,
    groups: [wgpu::BindGroup; 2],
    dispatch: wgpu::Buffer,
    pixels: Shown,
    tallies: Shown,
    max_rows: u32,
    rows: Range<u32>,
    /// Pixels of the next dispatch.
    portion: f64,
}

impl<'a, R: Real> Sampled<'a, R> {
    /// Uploads a flattened scene and compiles the shaders that it calls for.
    ///
    /// # Errors
    ///
    /// [`Error::Limit`] when the scene does not fit the device, or a path meets more
    /// primitives than a dispatch may test; [`Error::Shader`] when the driver refuses a shader.
    pub fn new(gpu: &'a Gpu, flat: &'a Flat<R>, portions: Portions) -> Result<Self> {
        check_tests(flat, portions)?;
        let loaded = Loaded::new(gpu, flat, Entry::Samples, portions, &|_| {})?;
        let bytes_of_pixel = size_of::<Pixel>() as u64;
        let limit = gpu.limits.max_storage_buffer_binding_size / bytes_of_pixel;
        let most = limit.min(BAND.into()) as u32;
        let [width, height] = flat.size;
        let max_rows = (most / width).clamp(1, height);
        let count = u64::from(max_rows) * u64::from(width);
        let uniform = BufferUsages::UNIFORM | BufferUsages::STORAGE | BufferUsages::COPY_DST;
        let dispatch = gpu.create_buffer("dispatch", size_of::<Dispatch>() as u64, uniform)?;
        let pixels = Shown::new(gpu, "pixels", count * bytes_of_pixel)?;
        let tallies = Shown::new(gpu, "tallies", count * size_of::<Tally>() as u64)?;
        let mut frame = uniforms(gpu, flat, &loaded.tables)?;
        let sampling = bytes_of(&loaded.sampling);
        let lamps = bytes_of(&loaded.lights.lamps);
        let environment = bytes_of(&loaded.lights.environment);
        frame.extend([
            ("dispatch", dispatch.clone()),
            ("pixels", pixels.buffer.clone()),
            ("tallies", tallies.buffer.clone()),
            ("sampling", gpu.upload_uniform("sampling", sampling)?),
            ("lamps", gpu.upload_uniform("lamps", lamps)?),
            (
                "environment",
                gpu.upload_uniform("environment", environment)?,
            ),
            ("lens", gpu.upload_uniform("lens", bytes_of(&flat.lens))?),
            (
                "motion",
                gpu.upload_uniform("motion", bytes_of(&loaded.motion))?,
            ),
            ("fog", gpu.upload_uniform("fog", bytes_of(&flat.fog))?),
        ]);
        let groups = loaded.bind(gpu, &frame)?;
        Ok(Self {
            gpu,
            flat,
            kernel: loaded.kernel,
            groups,
            dispatch,
            pixels,
            tallies,
            max_rows,
            rows: 0..0,
            portion: FIRST_PIXELS,
        })
    }

    /// Rows of the next tile.
    fn tile_rows(&self) -> u32 {
        let rows = (self.portion / f64::from(self.flat.size[0])) as u32;
        (rows / WORKGROUP * WORKGROUP).max(WORKGROUP)
    }

    /// Takes a finished dispatch into account: the next one is to take [`DISPATCH_TIME`], and
    /// it may only quadruple, for the first may have held the driver's compiling.
    fn learn(&mut self, pixels: u32, took: Duration) {
        let took = took.max(Duration::from_micros(1)).as_secs_f64();
        let wanted = f64::from(pixels) * DISPATCH_TIME.as_secs_f64() / took;
        self.portion = wanted.min(f64::from(pixels) * 4.0);
    }
}

/// Whether a dispatch can test all that a path may meet where there is no tree.
fn check_tests<R>(flat: &Flat<R>, portions: Portions) -> Result<()> {
    let legs = 1 + flat.sampling.bounces + flat.sampling.reflections;
    let rays = u64::from(legs) * ((flat.lights.len() + flat.lamps.len()) as u64 + 3);
    let tests = u64::from(flat.primitives()) + flat.volumes.len() as u64;
    if flat.pairs.is_empty() && tests * rays > u64::from(portions.primitives_per_dispatch) {
        return Err(Error::Limit(format!(
            "{tests} primitives and volumes, met by up to {rays} rays of a path, are more than a \
             dispatch goes through: take bounds `tree`"
        )));
    }
    Ok(())
}

impl<R: Real> Sampler for Sampled<'_, R> {
    fn max_rows(&self) -> u32 {
        self.max_rows
    }

    fn start(&mut self, rows: Range<u32>) {
        self.rows = rows;
    }

    fn take(
        &mut self,
        sample: u32,
        watch: &dyn Watch,
        progress: &(dyn Fn(f64) + Sync),
    ) -> Result<()> {
        let Range { start, end } = self.rows;
        let mut first_row = start;
        while first_row < end {
            if watch.cancelled() {
                return Err(Error::Interrupted);
            }
            let tile = Tile {
                first_row,
                rows: self.tile_rows().min(end - first_row),
                spread: self.gpu.adapter.is_software(),
            };
            let orders = Dispatch {
                sample,
                band_row: start,
                ..tile.all_orders(self.flat)
            };
            let began = Instant::now();
            let queue = &self.gpu.queue;
            queue.write_buffer(&self.dispatch, 0, bytemuck::bytes_of(&orders));
            let [frame, scene] = &self.groups;
            let workgroups = tile.workgroups(&orders);
            self.kernel
                .run(self.gpu, "sample_tile", &[frame, scene], workgroups, None)?;
            self.learn(tile.rows * self.flat.size[0], began.elapsed());
            first_row += tile.rows;
            progress(f64::from(first_row - start) / f64::from(end - start));
        }
        Ok(())
    }

    fn look(&mut self, see: &mut dyn FnMut(&[Pixel], &[Tally])) -> Result<()> {
        let count = self.rows.len() as u64 * u64::from(self.flat.size[0]);
        let mut tallies: Vec<Tally> = Vec::new();
        let bytes = count * size_of::<Tally>() as u64;
        self.tallies.look(self.gpu, bytes, &mut |bytes| {
            tallies = bytemuck::pod_collect_to_vec(bytes);
        })?;
        let bytes = count * size_of::<Pixel>() as u64;
        self.pixels.look(self.gpu, bytes, &mut |bytes| {
            // Mapped memory begins at a page.
            see(bytemuck::cast_slice(bytes), &tallies);
        })
    }
}

/// A buffer that shaders write and the host reads.
struct Shown {
    buffer: wgpu::Buffer,
    /// Where it is copied to be read; none where it is read in place.
    staging: Option<wgpu::Buffer>,
}

impl Shown {
    fn new(gpu: &Gpu, name: &'static str, bytes: u64) -> Result<Self> {
        let staged = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        let in_place = gpu.maps_storage();
        let usage = if in_place {
            BufferUsages::STORAGE | BufferUsages::MAP_READ
        } else {
            BufferUsages::STORAGE | BufferUsages::COPY_SRC
        };
        let staging = (!in_place).then(|| gpu.create_buffer("staging", bytes, staged));
        Ok(Self {
            buffer: gpu.create_buffer(name, bytes, usage)?,
            staging: staging.transpose()?,
        })
    }

    fn look(&self, gpu: &Gpu, bytes: u64, see: &mut dyn FnMut(&[u8])) -> Result<()> {
        if let Some(staging) = &self.staging {
            gpu.copy(&self.buffer, staging, bytes);
        }
        gpu.look_at(self.staging.as_ref().unwrap_or(&self.buffer), bytes, see)
    }
}

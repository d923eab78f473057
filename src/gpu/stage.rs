//! All the buffers of one render, bound to the shader's variables by name.

use std::collections::HashMap;

use wgpu::BufferUsages;

use super::device::Gpu;
use super::kernel::Kernel;
use super::loaded::Loaded;
use super::portions::Portions;
use super::scene::push_parts;
use super::screen::Screen;
use super::timestamps::Clock;
use crate::error::Result;
use crate::flat::Flat;
use crate::kernel::real::Real;
use crate::layout::{Dispatch, HitRecord, Pixel, Tables};
use crate::tier::{Formulas, Width};

/// What is the same for all invocations of a picture, by the names of the variables.
///
/// # Errors
///
/// [`crate::Error::Limit`] when the device has not that much memory.
pub(super) fn uniforms<R: Real>(
    gpu: &Gpu,
    flat: &Flat<R>,
    tables: &Tables,
) -> Result<HashMap<&'static str, wgpu::Buffer>> {
    let mut camera = Vec::new();
    let numbers: &[R] = bytemuck::cast_slice(std::slice::from_ref(&flat.camera));
    for four in numbers.as_chunks().0 {
        push_parts(&mut camera, *four);
    }
    let surroundings = bytemuck::bytes_of(&flat.surroundings);
    Ok(HashMap::from([
        (
            "camera",
            gpu.upload_uniform("camera", bytemuck::cast_slice(&camera))?,
        ),
        (
            "surroundings",
            gpu.upload_uniform("surroundings", surroundings)?,
        ),
        (
            "tables",
            gpu.upload_uniform("tables", bytemuck::bytes_of(tables))?,
        ),
    ]))
}

/// Bytes of a `HitRecord` in the shader: t, then three words, aligned as t is.
fn hit_bytes(width: Width) -> u64 {
    match width {
        Width::Single => size_of::<HitRecord>() as u64,
        Width::Extended | Width::Double => 24,
    }
}

/// Pixels of a tile at most: 48 MiB of them.
const PIXELS_PER_TILE: u32 = 1 << 20;

/// All the buffers of one render.
pub(super) struct Stage {
    /// The highest tile that the buffers hold.
    pub(super) max_rows: u32,
    frame: wgpu::BindGroup,
    scene: wgpu::BindGroup,
    dispatch: wgpu::Buffer,
    pub(super) pixels: wgpu::Buffer,
    /// Volumes tested and met, a pixel; empty where they are not counted.
    counts: wgpu::Buffer,
    /// Where pixels are copied to be read; none where they can be read in place.
    staging: Option<wgpu::Buffer>,
    /// How many rays of the tile are in doubt, then which; empty where none can be.
    pub(super) doubtful: wgpu::Buffer,
    /// None where the passes are not timed, or cannot be.
    clock: Option<Clock>,
}

impl Stage {
    /// Makes room for a tile of a scene that was uploaded.
    ///
    /// # Errors
    ///
    /// [`crate::Error::Limit`] when the device has not that much memory.
    pub(super) fn set_up<R: Real>(
        gpu: &Gpu,
        flat: &Flat<R>,
        loaded: &Loaded,
        screen: &Screen,
        portions: Portions,
    ) -> Result<Self> {
        let pixel_limit = gpu.limits.max_storage_buffer_binding_size / size_of::<Pixel>() as u64;
        let max_pixels = u64::from(PIXELS_PER_TILE).min(pixel_limit) as u32;
        let max_rows = (max_pixels / flat.size[0]).clamp(1, flat.size[1]);
        let tile = u64::from(max_rows) * u64::from(flat.size[0]);
        let pixel_bytes = tile * size_of::<Pixel>() as u64;
        let cursors = if flat.volumes.is_empty() { 0 } else { tile };

        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let working = BufferUsages::STORAGE | BufferUsages::COPY_SRC;
        let staged = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        let in_place = gpu.maps_storage();
        let dispatch = gpu.create_buffer("dispatch", size_of::<Dispatch>() as u64, uniform)?;
        let readable = if in_place {
            BufferUsages::STORAGE | BufferUsages::MAP_READ
        } else {
            working
        };
        let pixels = gpu.create_buffer("pixels", pixel_bytes, readable)?;
        let counted = if portions.count { tile } else { 0 };
        let count_bytes = counted * size_of::<[u32; 2]>() as u64;
        let counts = gpu.create_buffer("counts", count_bytes, working)?;
        let staging = (!in_place).then(|| gpu.create_buffer("staging", pixel_bytes, staged));
        let bounded = R::FORMULAS == Formulas::Bounded;
        let list = if bounded { 1 + tile } else { 0 };
        let list_bytes = list * size_of::<u32>() as u64;
        let doubtful =
            gpu.create_buffer("doubtful", list_bytes, readable | BufferUsages::COPY_DST)?;
        let bounds = if bounded { tile } else { 0 };
        let mut frame = uniforms(gpu, flat, &loaded.tables)?;
        frame.extend([
            ("dispatch", dispatch.clone()),
            ("doubtful", doubtful.clone()),
            (
                "bounds",
                gpu.create_buffer("bounds", bounds * size_of::<[f32; 4]>() as u64, working)?,
            ),
            (
                "hits",
                gpu.create_buffer("hits", tile * hit_bytes(R::WIDTH), working)?,
            ),
            (
                "cursors",
                gpu.create_buffer("cursors", cursors * size_of::<[u32; 2]>() as u64, working)?,
            ),
            ("counts", counts.clone()),
            ("masks", screen.masks.clone()),
            ("split", screen.split.clone()),
            ("pixels", pixels.clone()),
        ]);
        let [frame, scene] = loaded.bind(gpu, &frame)?;
        Ok(Self {
            max_rows,
            frame,
            scene,
            dispatch,
            pixels,
            doubtful,
            counts,
            staging: staging.transpose()?,
            clock: if portions.time { Clock::of(gpu)? } else { None },
        })
    }

    /// The clock by which passes are timed, if they are.
    pub(super) fn clock(&self) -> Option<&Clock> {
        self.clock.as_ref()
    }

    /// Whether the passes are timed.
    pub(super) fn has_clock(&self) -> bool {
        self.clock.is_some()
    }

    /// Runs one entry point, and waits; gives the seconds as
    /// [`Kernel::run`].
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn dispatch(
        &self,
        gpu: &Gpu,
        kernel: &Kernel,
        entry: &str,
        workgroups: [u32; 3],
        orders: &Dispatch,
    ) -> Result<f64> {
        gpu.queue
            .write_buffer(&self.dispatch, 0, bytemuck::bytes_of(orders));
        kernel.run(
            gpu,
            entry,
            &[&self.frame, &self.scene],
            workgroups,
            self.clock.as_ref(),
        )
    }

    /// Shows the first `count` pixels of the tile.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn look_at_pixels(
        &self,
        gpu: &Gpu,
        count: u32,
        look: &mut dyn FnMut(&[Pixel]),
    ) -> Result<()> {
        let bytes = u64::from(count) * size_of::<Pixel>() as u64;
        if let Some(staging) = &self.staging {
            gpu.copy(&self.pixels, staging, bytes);
        }
        let readable = self.staging.as_ref().unwrap_or(&self.pixels);
        // Mapped memory begins at a page.
        gpu.look_at(readable, bytes, &mut |bytes| {
            look(bytemuck::cast_slice(bytes))
        })
    }

    /// Volumes tested and met by the first `count` pixels of the tile.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn read_counts(&self, gpu: &Gpu, count: u32) -> Result<Vec<[u32; 2]>> {
        let bytes = u64::from(count) * size_of::<[u32; 2]>() as u64;
        let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        let staging = gpu.create_buffer("counts read", bytes, usage)?;
        let data = gpu.read_back(&self.counts, &staging, bytes)?;
        Ok(bytemuck::pod_collect_to_vec(&data))
    }
}

//! The pre-pass that sorts volumes to the tiles of the screen, level by level.

use wgpu::BufferUsages;

use super::device::Gpu;
use super::kernel::Kernel;
use super::stage::Stage;
use super::tile::Tile;
use crate::bounds::screen::{Level, levels};
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::layout::ScreenLevel;
use crate::watch::Watch;

/// Invocations of a workgroup of `split_tiles`.
const WORKGROUP: u32 = 64;

/// The buffers of the pre-pass.
pub(super) struct Screen {
    levels: Vec<Level>,
    words: u32,
    pub(super) masks: wgpu::Buffer,
    pub(super) split: wgpu::Buffer,
}

impl Screen {
    /// Makes room for the masks of all levels; for none where the screen is not divided.
    ///
    /// # Errors
    ///
    /// [`crate::Error::Limit`] when the device has not that much memory.
    pub(super) fn set_up<R>(gpu: &Gpu, flat: &Flat<R>) -> Result<Self> {
        let words = flat.tile_words;
        let levels = if words == 0 {
            Vec::new()
        } else {
            levels(flat.size, words)
        };
        let total = levels.last().map_or(0, |root| root.split.first + words);
        let bytes = u64::from(total) * size_of::<u32>() as u64;
        let working = BufferUsages::STORAGE | BufferUsages::COPY_SRC;
        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        Ok(Self {
            levels,
            words,
            masks: gpu.create_buffer("masks", bytes, working)?,
            split: gpu.create_buffer("split", size_of::<ScreenLevel>() as u64, uniform)?,
        })
    }

    /// Divides the screen, from the largest tile down; gives the seconds by the device's
    /// clock.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`]; [`Error::Interrupted`] when `watch` says so.
    pub(super) fn divide<R>(
        &self,
        gpu: &Gpu,
        kernel: &Kernel,
        stage: &Stage,
        flat: &Flat<R>,
        watch: &dyn Watch,
    ) -> Result<f64> {
        let whole = Tile {
            first_row: 0,
            rows: flat.size[1],
            spread: false,
        };
        let orders = whole.orders(flat, 0..0);
        let mut seconds = 0.0;
        for level in self.levels.iter().rev() {
            if watch.cancelled() {
                return Err(Error::Interrupted);
            }
            gpu.queue
                .write_buffer(&self.split, 0, bytemuck::bytes_of(&level.split));
            let across = (level.split.across * self.words).div_ceil(WORKGROUP);
            let workgroups = [across, level.down, 1];
            seconds += stage.dispatch(gpu, kernel, "split_tiles", workgroups, &orders)?;
        }
        Ok(seconds)
    }
}

//! How long a pass takes by the device's own clock: without the waiting for it.

use wgpu::BufferUsages;

use super::device::Gpu;
use crate::error::Result;

/// A pass's begin and end, in ticks.
const BYTES: u64 = size_of::<[u64; 2]>() as u64;

/// The device's clock, for one pass at a time.
pub(super) struct Clock {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    readable: wgpu::Buffer,
}

impl Clock {
    /// The device's clock, if it has one.
    ///
    /// # Errors
    ///
    /// [`crate::Error::Limit`] when the device has no memory for it.
    pub(super) fn of(gpu: &Gpu) -> Result<Option<Self>> {
        if !gpu.has_clock() {
            return Ok(None);
        }
        let queries = gpu.guard("the clock", || {
            gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: None,
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            })
        })?;
        let resolved = BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC;
        let readable = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        Ok(Some(Self {
            queries,
            resolved: gpu.create_buffer("ticks", BYTES, resolved)?,
            readable: gpu.create_buffer("ticks read", BYTES, readable)?,
        }))
    }

    /// Has a pass note its begin and its end.
    pub(super) fn of_pass(&self) -> wgpu::ComputePassTimestampWrites<'_> {
        wgpu::ComputePassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        }
    }

    /// Has what the pass noted made readable.
    pub(super) fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.resolve_query_set(&self.queries, 0..2, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.readable, 0, BYTES);
    }

    /// The seconds that the last pass took.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn seconds(&self, gpu: &Gpu) -> Result<f64> {
        let mut ticks = [0u64; 2];
        gpu.look_at(&self.readable, BYTES, &mut |bytes| {
            bytemuck::bytes_of_mut(&mut ticks).copy_from_slice(bytes);
        })?;
        let nanoseconds = f64::from(gpu.queue.get_timestamp_period());
        Ok(ticks[1].saturating_sub(ticks[0]) as f64 * nanoseconds * 1e-9)
    }
}

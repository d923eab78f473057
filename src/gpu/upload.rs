//! Buffers: made, filled and read back, with every refusal reported.

use wgpu::BufferUsages;

use super::device::Gpu;
use crate::error::{Error, Result};

impl Gpu {
    /// A zeroed buffer of at least `bytes` bytes.
    ///
    /// # Errors
    ///
    /// [`Error::Limit`] when the device has not that much memory.
    pub(super) fn create_buffer(
        &self,
        name: &str,
        bytes: u64,
        usage: BufferUsages,
    ) -> Result<wgpu::Buffer> {
        // A binding must not be empty; 64 bytes hold one element of any array.
        let bytes = if bytes == 0 { 64 } else { bytes };
        let size = bytes.next_multiple_of(wgpu::COPY_BUFFER_ALIGNMENT);
        if size > self.limits.max_buffer_size {
            return Err(Error::Limit(format!(
                "the buffer `{name}` needs {size} bytes; {} allows {} a buffer",
                self.adapter.name, self.limits.max_buffer_size
            )));
        }
        self.guard(&format!("the buffer `{name}` of {size} bytes"), || {
            self.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(name),
                size,
                usage,
                mapped_at_creation: false,
            })
        })
    }

    /// What `create` creates, unless the device refuses it.
    ///
    /// # Errors
    ///
    /// [`Error::Limit`] with the device's words, which tell of `what`.
    pub(super) fn guard<T>(&self, what: &str, create: impl FnOnce() -> T) -> Result<T> {
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let invalid = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let created = create();
        let refused = pollster::block_on(invalid.pop());
        match pollster::block_on(memory.pop()).or(refused) {
            Some(error) => Err(Error::Limit(format!("{what}: {error}"))),
            None => Ok(created),
        }
    }

    /// A storage buffer that holds `bytes`.
    ///
    /// # Errors
    ///
    /// As [`Gpu::create_buffer`].
    pub(super) fn upload(&self, name: &str, bytes: &[u8]) -> Result<wgpu::Buffer> {
        let most = self.limits.max_storage_buffer_binding_size;
        if bytes.len() as u64 > most {
            return Err(Error::Limit(format!(
                "the buffer `{name}` takes {} bytes; {} binds {most} at once",
                bytes.len(),
                self.adapter.name
            )));
        }
        let usage = BufferUsages::STORAGE | BufferUsages::COPY_DST;
        let buffer = self.create_buffer(name, bytes.len() as u64, usage)?;
        self.queue.write_buffer(&buffer, 0, bytes);
        Ok(buffer)
    }

    /// A uniform buffer that holds `bytes`.
    ///
    /// # Errors
    ///
    /// As [`Gpu::create_buffer`].
    pub(super) fn upload_uniform(&self, name: &str, bytes: &[u8]) -> Result<wgpu::Buffer> {
        // A storage buffer for drivers that do harm with uniforms.
        let usage = BufferUsages::UNIFORM | BufferUsages::STORAGE | BufferUsages::COPY_DST;
        let buffer = self.create_buffer(name, bytes.len() as u64, usage)?;
        self.queue.write_buffer(&buffer, 0, bytes);
        Ok(buffer)
    }

    /// The first `bytes` bytes of `buffer`, by way of `staging`.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn read_back(
        &self,
        buffer: &wgpu::Buffer,
        staging: &wgpu::Buffer,
        bytes: u64,
    ) -> Result<Vec<u8>> {
        self.copy(buffer, staging, bytes);
        let mut data = Vec::new();
        self.look_at(staging, bytes, &mut |mapped| data = mapped.to_vec())?;
        Ok(data)
    }

    /// Has the first `bytes` bytes of `buffer` copied to `staging`.
    pub(super) fn copy(&self, buffer: &wgpu::Buffer, staging: &wgpu::Buffer, bytes: u64) {
        let mut encoder = self.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(buffer, 0, staging, 0, bytes);
        self.queue.submit([encoder.finish()]);
    }

    /// Shows the first `bytes` bytes of a mappable buffer, where they lie.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn look_at(
        &self,
        buffer: &wgpu::Buffer,
        bytes: u64,
        look: &mut dyn FnMut(&[u8]),
    ) -> Result<()> {
        buffer.map_async(wgpu::MapMode::Read, 0..bytes, |_| {});
        self.wait()?;
        look(
            &buffer
                .get_mapped_range(0..bytes)
                .map_err(|error| Error::DeviceLost(error.to_string()))?,
        );
        buffer.unmap();
        Ok(())
    }
}

//! All the buffers of one render, bound to the shader's variables by name.

use std::collections::HashMap;
use std::ops::Range;

use bytemuck::Pod;
use wgpu::BufferUsages;

use super::device::Gpu;
use super::kernel::Kernel;
use super::window::Window;
use crate::error::Result;
use crate::flat::Flat;
use crate::layout::{Dispatch, Pixel};

/// Pixels of a tile at most: 48 MiB of them.
const PIXELS_PER_TILE: u32 = 1 << 20;

/// Invocations of a workgroup across and down, as the shader says.
pub(super) const WORKGROUP: u32 = 8;

/// All the buffers of one render.
pub(super) struct Stage {
    /// The highest tile that the buffers hold.
    pub(super) max_rows: u32,
    frame: wgpu::BindGroup,
    shading: wgpu::BindGroup,
    windows: Vec<wgpu::BindGroup>,
    dispatch: wgpu::Buffer,
    pixels: wgpu::Buffer,
    staging: wgpu::Buffer,
}

impl Stage {
    /// Uploads the scene and makes room for a tile.
    ///
    /// # Errors
    ///
    /// [`crate::Error::Limit`] when the device has not that much memory.
    pub(super) fn set_up(
        gpu: &Gpu,
        flat: &Flat<f32>,
        kernel: &Kernel,
        windows: &[Window],
    ) -> Result<Self> {
        let pixel_limit = gpu.limits.max_storage_buffer_binding_size / size_of::<Pixel>() as u64;
        let max_pixels = u64::from(PIXELS_PER_TILE).min(pixel_limit) as u32;
        let max_rows = (max_pixels / flat.size[0]).clamp(1, flat.size[1]);
        let tile = u64::from(max_rows) * u64::from(flat.size[0]);
        let pixel_bytes = tile * size_of::<Pixel>() as u64;

        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let working = BufferUsages::STORAGE | BufferUsages::COPY_SRC;
        let staged = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        let dispatch = gpu.create_buffer("dispatch", size_of::<Dispatch>() as u64, uniform)?;
        let pixels = gpu.create_buffer("pixels", pixel_bytes, working)?;
        let frame = HashMap::from([
            ("dispatch", dispatch.clone()),
            (
                "camera",
                gpu.upload_uniform("camera", bytemuck::bytes_of(&flat.camera))?,
            ),
            (
                "closest_t",
                gpu.create_buffer("closest_t", tile * 4, working)?,
            ),
            ("pixels", pixels.clone()),
            (
                "surroundings",
                gpu.upload_uniform("surroundings", bytemuck::bytes_of(&flat.surroundings))?,
            ),
        ]);
        let shading = HashMap::from([
            (
                "materials",
                gpu.upload("materials", bytemuck::cast_slice(&flat.materials))?,
            ),
            (
                "lights",
                gpu.upload("lights", bytemuck::cast_slice(&flat.lights))?,
            ),
        ]);
        Ok(Self {
            max_rows,
            frame: kernel.bind(gpu, 0, &frame)?,
            shading: kernel.bind(gpu, 1, &shading)?,
            windows: windows
                .iter()
                .map(|window| kernel.bind(gpu, 2, &upload_window(gpu, flat, window)?))
                .collect::<Result<_>>()?,
            dispatch,
            pixels,
            staging: gpu.create_buffer("staging", pixel_bytes, staged)?,
        })
    }

    /// Runs one entry point over a tile with the buffers of a window, and waits.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn dispatch(
        &self,
        gpu: &Gpu,
        kernel: &Kernel,
        entry: &str,
        window: usize,
        orders: &Dispatch,
    ) -> Result<()> {
        gpu.queue
            .write_buffer(&self.dispatch, 0, bytemuck::bytes_of(orders));
        let groups = [&self.frame, &self.shading, &self.windows[window]];
        let workgroups = [
            orders.size[0].div_ceil(WORKGROUP),
            orders.rows.div_ceil(WORKGROUP),
        ];
        kernel.run(gpu, entry, &groups, workgroups)
    }

    /// The first `count` pixels of the tile.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn read_pixels(&self, gpu: &Gpu, count: u32) -> Result<Vec<Pixel>> {
        let bytes = u64::from(count) * size_of::<Pixel>() as u64;
        let data = gpu.read_back(&self.pixels, &self.staging, bytes)?;
        Ok(bytemuck::pod_collect_to_vec(&data))
    }
}

/// The primitives of a window and their materials.
fn upload_window(
    gpu: &Gpu,
    flat: &Flat<f32>,
    window: &Window,
) -> Result<HashMap<&'static str, wgpu::Buffer>> {
    let normals = if flat.corner_normals.is_empty() {
        0..0
    } else {
        window.triangles(flat)
    };
    let materials = window.ids.start as usize..window.ids.end as usize;
    let indices = [&flat.material_indices[materials], flat.leaf_ids.as_slice()].concat();
    Ok(HashMap::from([
        (
            "indices",
            gpu.upload("indices", bytemuck::cast_slice(&indices))?,
        ),
        (
            "pairs",
            gpu.upload("pairs", bytemuck::cast_slice(&flat.pairs))?,
        ),
        upload_part(gpu, "spheres", &flat.spheres, window.spheres(flat))?,
        upload_part(gpu, "planes", &flat.planes, window.planes(flat))?,
        upload_part(gpu, "disks", &flat.disks, window.disks(flat))?,
        upload_part(gpu, "triangles", &flat.triangles, window.triangles(flat))?,
        upload_part(gpu, "corner_normals", &flat.corner_normals, normals)?,
    ]))
}

fn upload_part<T: Pod>(
    gpu: &Gpu,
    name: &'static str,
    records: &[T],
    part: Range<u32>,
) -> Result<(&'static str, wgpu::Buffer)> {
    let part = &records[part.start as usize..part.end as usize];
    Ok((name, gpu.upload(name, bytemuck::cast_slice(part))?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::effects::{DIVIDE_NATIVE, select_files};
    use crate::gpu::program::Program;

    #[test]
    fn the_shader_has_workgroups_of_this_size() {
        let program = Program::build(&select_files(|_| true, DIVIDE_NATIVE)).unwrap();
        for entry in &program.module.entry_points {
            assert_eq!(entry.workgroup_size, [WORKGROUP, WORKGROUP, 1]);
        }
    }
}

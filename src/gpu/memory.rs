//! Where the scene lies on the device: storage buffer, texture or uniform buffer.

use wgpu::{BufferUsages, TextureUsages};

use super::device::Gpu;
use super::scene::{PackedScene, Quad};
use crate::effects::Fetch;
use crate::error::{Error, Result};

/// Quads of a texture's row, as `fetch_texture.wgsl` has them.
const ROW: u32 = 1 << 13;

/// Quads of a uniform buffer, as `fetch_uniform.wgsl` has them.
const UNIFORM: usize = 4096;

/// Bytes handed over at once: the queue keeps a copy until it is done.
const PORTION: usize = 16 << 20;

/// A scene on a device.
pub(super) enum SceneMemory {
    Buffer(wgpu::Buffer),
    Texture(wgpu::TextureView),
}

impl SceneMemory {
    /// Uploads a scene.
    ///
    /// # Errors
    ///
    /// [`Error::Limit`] when the device has not that much memory.
    pub(super) fn upload(gpu: &Gpu, scene: &PackedScene, fetch: Fetch) -> Result<Self> {
        check_fits(gpu, scene, fetch)?;
        match fetch {
            Fetch::Storage => upload_buffer(gpu, scene, BufferUsages::STORAGE, scene.bytes()),
            Fetch::Uniform => {
                let bytes = UNIFORM * size_of::<Quad>();
                upload_buffer(gpu, scene, BufferUsages::UNIFORM, bytes as u64)
            }
            Fetch::Texture => upload_texture(gpu, &scene.quads),
        }
    }

    /// As the shader's variable `scene`.
    pub(super) fn binding(&self) -> wgpu::BindingResource<'_> {
        match self {
            Self::Buffer(buffer) => buffer.as_entire_binding(),
            Self::Texture(view) => wgpu::BindingResource::TextureView(view),
        }
    }
}

/// The ways of reading a scene, the best for this kind of device first: software reads
/// what is small best from a uniform buffer, and the rest from a texture; hardware from a
/// storage buffer. `doctor` measures whether that holds, see [`super::fetch_probe`].
pub(super) fn order(gpu: &Gpu) -> [Fetch; 3] {
    if gpu.adapter.is_software() {
        [Fetch::Uniform, Fetch::Texture, Fetch::Storage]
    } else {
        [Fetch::Storage, Fetch::Texture, Fetch::Uniform]
    }
}

/// The first way of the order in which the scene fits.
pub(super) fn best_fetch(gpu: &Gpu, scene: &PackedScene) -> Fetch {
    let order = order(gpu);
    let fits = |fetch: &Fetch| scene.bytes() <= capacity(gpu, *fetch);
    order.into_iter().find(fits).unwrap_or(order[1])
}

/// Bytes that can be read in one way.
pub(super) fn capacity(gpu: &Gpu, fetch: Fetch) -> u64 {
    let limits = &gpu.limits;
    match fetch {
        Fetch::Storage => limits
            .max_storage_buffer_binding_size
            .min(limits.max_buffer_size),
        Fetch::Texture if limits.max_texture_dimension_2d >= ROW => {
            let texels = u64::from(limits.max_texture_dimension_2d) * u64::from(ROW);
            texels * size_of::<Quad>() as u64
        }
        Fetch::Uniform => {
            let bytes = (UNIFORM * size_of::<Quad>()) as u64;
            if limits.max_uniform_buffer_binding_size >= bytes {
                bytes
            } else {
                0
            }
        }
        Fetch::Texture => 0,
    }
}

fn check_fits(gpu: &Gpu, scene: &PackedScene, fetch: Fetch) -> Result<()> {
    let (needed, most) = (scene.bytes(), capacity(gpu, fetch));
    if needed <= most {
        return Ok(());
    }
    Err(Error::Limit(format!(
        "the scene takes {needed} bytes; {} reads {most} at most: add `--backend cpu`",
        gpu.adapter.name
    )))
}

fn upload_buffer(
    gpu: &Gpu,
    scene: &PackedScene,
    usage: BufferUsages,
    bytes: u64,
) -> Result<SceneMemory> {
    let buffer = gpu.create_buffer("scene", bytes, usage | BufferUsages::COPY_DST)?;
    let bytes: &[u8] = bytemuck::cast_slice(&scene.quads);
    for (portion, begin) in bytes.chunks(PORTION).zip((0..).step_by(PORTION)) {
        gpu.queue.write_buffer(&buffer, begin, portion);
        gpu.queue.submit([]);
    }
    Ok(SceneMemory::Buffer(buffer))
}

fn upload_texture(gpu: &Gpu, quads: &[Quad]) -> Result<SceneMemory> {
    let width = ROW.min(quads.len() as u32);
    let height = quads.len().div_ceil(ROW as usize) as u32;
    let size = wgpu::Extent3d {
        width,
        height,
        depth_or_array_layers: 1,
    };
    let texture = gpu.guard("the scene's texture", || {
        gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("scene"),
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Uint,
            usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
            view_formats: &[],
        })
    })?;
    let rows = PORTION / (ROW as usize * size_of::<Quad>());
    for (portion, first) in quads.chunks(rows * ROW as usize).zip((0..).step_by(rows)) {
        // A last row that is not full is an upload of its own.
        let whole = portion.len() / width as usize * width as usize;
        for (part, down) in [
            (&portion[..whole], 0),
            (&portion[whole..], whole as u32 / width),
        ] {
            write_rows(gpu, &texture, part, first as u32 + down, width);
        }
        gpu.queue.submit([]);
    }
    Ok(SceneMemory::Texture(
        texture.create_view(&Default::default()),
    ))
}

/// Writes whole rows, or a part of one.
fn write_rows(gpu: &Gpu, texture: &wgpu::Texture, quads: &[Quad], first: u32, width: u32) {
    if quads.is_empty() {
        return;
    }
    gpu.queue.write_texture(
        wgpu::TexelCopyTextureInfo {
            texture,
            mip_level: 0,
            origin: wgpu::Origin3d {
                x: 0,
                y: first,
                z: 0,
            },
            aspect: wgpu::TextureAspect::All,
        },
        bytemuck::cast_slice(quads),
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(width * size_of::<Quad>() as u32),
            rows_per_image: None,
        },
        wgpu::Extent3d {
            width: width.min(quads.len() as u32),
            height: (quads.len() as u32).div_ceil(width),
            depth_or_array_layers: 1,
        },
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shaders_have_these_sizes() {
        let texture = include_str!("../../shaders/fetch_texture.wgsl");
        let bits = ROW.trailing_zeros();
        assert!(texture.contains(&format!("ROW_BITS: u32 = {bits}u;")));
        let uniform = include_str!("../../shaders/fetch_uniform.wgsl");
        assert!(uniform.contains(&format!("array<vec4<u32>, {UNIFORM}>")));
        // The control: other sizes are not there.
        assert!(!texture.contains(&format!("ROW_BITS: u32 = {}u;", bits + 1)));
        assert!(!uniform.contains(&format!("array<vec4<u32>, {}>", UNIFORM + 1)));
    }
}

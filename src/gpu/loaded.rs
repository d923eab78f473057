//! A scene on a device with the shader that it calls for.

use std::collections::HashMap;

use super::device::Gpu;
use super::kernel::Kernel;
use super::memory::{SceneMemory, best_fetch};
use super::portions::Portions;
use super::program::Source;
use super::scene::{LightTables, PackedScene};
use crate::effects::{Device, Effect, Entry, Fetch, select_files};
use crate::error::Result;
use crate::flat::Flat;
use crate::kernel::real::Real;
use crate::layout::{MotionRecord, SamplingRecord, Tables};

/// A scene, uploaded, and its shader, compiled.
pub(super) struct Loaded {
    pub(super) kernel: Kernel,
    /// Where the scene's tables begin.
    pub(super) tables: Tables,
    /// How paths of light are sampled, and where their tables begin.
    pub(super) sampling: SamplingRecord,
    /// Where the tables of lights lie that are no points.
    pub(super) lights: LightTables,
    /// How far things go while the shutter is open.
    pub(super) motion: MotionRecord,
    /// Where the scene lies.
    pub(super) fetch: Fetch,
    memory: SceneMemory,
}

impl Loaded {
    /// Compiles the shader with this entry, its files changed by `change` first, and uploads
    /// the scene.
    ///
    /// # Errors
    ///
    /// [`crate::Error::Limit`] when the scene does not fit the device,
    /// [`crate::Error::Shader`] when the driver refuses the shader.
    pub(super) fn new<R: Real>(
        gpu: &Gpu,
        flat: &Flat<R>,
        entry: Entry,
        portions: Portions,
        change: &dyn Fn(&mut Vec<Source>),
    ) -> Result<Self> {
        let mut scene = PackedScene::of(flat, portions.forced);
        let mut sampling = flat.sampling;
        let mut lights = LightTables::default();
        let mut motion = MotionRecord::default();
        if entry == Entry::Samples {
            sampling = scene.add_path_tables(flat);
            lights = scene.add_light_tables(flat);
            motion = scene.add_motion_tables(flat);
        }
        let fetch = portions.fetch.unwrap_or_else(|| best_fetch(gpu, &scene));
        let device = Device {
            count: portions.count,
            formulas: R::FORMULAS,
            width: R::WIDTH,
            entry,
            divide: gpu.arithmetic.divide_file(),
            fetch,
        };
        let counts = flat.counts();
        let is_on = |effect: &Effect| effect.is_called_for(&counts) || portions.forced.has(effect);
        let mut files = select_files(is_on, device);
        change(&mut files);
        let kernel = gpu.kernel(&files, R::WIDTH)?;
        Ok(Self {
            kernel,
            memory: SceneMemory::upload(gpu, &scene, fetch)?,
            tables: scene.tables,
            sampling,
            lights,
            motion,
            fetch,
        })
    }

    /// Binds the buffers of a frame, by the names of their variables, and the scene.
    ///
    /// # Errors
    ///
    /// As [`Kernel::bind`].
    pub(super) fn bind(
        &self,
        gpu: &Gpu,
        frame: &HashMap<&'static str, wgpu::Buffer>,
    ) -> Result<[wgpu::BindGroup; 2]> {
        let frame = self.kernel.bind(gpu, 0, |name| {
            frame.get(name).map(|buffer| buffer.as_entire_binding())
        })?;
        let scene = self.kernel.bind(gpu, 1, |name| {
            (name == "scene").then(|| self.memory.binding())
        })?;
        Ok([frame, scene])
    }
}

//! Adapters and devices.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use serde::Serialize;
use wgpu::{Backends, DeviceType, Features};

use super::program::{Access, Program};
use super::selfcheck::{Arithmetic, measure_arithmetic};
use crate::error::{Error, Result};

/// How long one dispatch may take before the device counts as lost. Dispatches
/// are sized to take a tenth of a second; a driver that compiles a pipeline on
/// its first use may take some seconds.
const PATIENCE: Duration = Duration::from_secs(60);

/// What is said of an adapter.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct AdapterDescription {
    /// The device's name.
    pub name: String,
    /// The driver's name and version.
    pub driver: String,
    /// `discrete`, `integrated`, `virtual`, `software` or `other`.
    #[serde(rename = "type")]
    pub kind: &'static str,
    /// `vulkan`, `metal`, `dx12` or `gl`.
    pub backend: String,
}

impl AdapterDescription {
    /// Describes an adapter.
    pub fn of(adapter: &wgpu::Adapter) -> Self {
        let info = adapter.get_info();
        let kind = match info.device_type {
            DeviceType::DiscreteGpu => "discrete",
            DeviceType::IntegratedGpu => "integrated",
            DeviceType::VirtualGpu => "virtual",
            DeviceType::Cpu => "software",
            DeviceType::Other => "other",
        };
        let driver = [info.driver.trim(), info.driver_info.trim()]
            .into_iter()
            .filter(|part| !part.is_empty())
            .collect::<Vec<_>>()
            .join(" ");
        Self {
            name: info.name,
            driver,
            kind,
            backend: info.backend.to_string(),
        }
    }
}

/// All adapters, the most capable kind first; OpenGL ones, whose arithmetic is
/// less defined, last.
pub fn adapters() -> Vec<wgpu::Adapter> {
    let mut found = enumerate(Backends::PRIMARY);
    found.extend(enumerate(Backends::GL));
    found
}

fn enumerate(backends: Backends) -> Vec<wgpu::Adapter> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends,
        // lavapipe does not claim conformance; the self-check decides.
        flags: wgpu::InstanceFlags::ALLOW_UNDERLYING_NONCOMPLIANT_ADAPTER,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let mut found = pollster::block_on(instance.enumerate_adapters(backends));
    found.sort_by_key(|adapter| match adapter.get_info().device_type {
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu => 2,
        DeviceType::Other => 3,
        DeviceType::Cpu => 4,
    });
    found
}

/// The adapter to use: the best one, or the first whose name, driver or backend
/// contains `wanted`, whatever the case. OpenGL only where it is named.
fn choose(wanted: Option<&str>) -> Result<wgpu::Adapter> {
    let Some(wanted) = wanted else {
        return enumerate(Backends::PRIMARY)
            .into_iter()
            .next()
            .ok_or_else(|| Error::NoAdapter("this machine offers none".into()));
    };
    let needle = wanted.to_lowercase();
    let mut seen = Vec::new();
    for adapter in adapters() {
        let about = AdapterDescription::of(&adapter);
        let text = format!("{} {} {}", about.name, about.driver, about.backend).to_lowercase();
        if text.contains(&needle) {
            return Ok(adapter);
        }
        seen.push(about.name);
    }
    let seen = if seen.is_empty() {
        "none".to_string()
    } else {
        seen.join(", ")
    };
    Err(Error::NoAdapter(format!(
        "none matches `{wanted}`; this machine has: {seen}"
    )))
}

/// What went wrong on a device since it was opened.
#[derive(Debug, Default)]
struct Troubles {
    lost: Mutex<Option<String>>,
    errors: Mutex<Vec<String>>,
}

/// An open device.
#[derive(Debug)]
pub struct Gpu {
    /// What it is.
    pub adapter: AdapterDescription,
    /// What its arithmetic does.
    pub arithmetic: Arithmetic,
    /// Its limits.
    pub limits: wgpu::Limits,
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    /// What was asked for, for opening it again.
    wanted: Option<String>,
    exact: bool,
    troubles: Arc<Troubles>,
}

impl Gpu {
    /// Opens the best adapter, or the first whose name, driver or backend
    /// contains `wanted`, and measures its arithmetic.
    ///
    /// # Errors
    ///
    /// [`Error::NoAdapter`] where there is none, [`Error::DeviceLost`] where it
    /// does not open.
    pub fn open(wanted: Option<&str>) -> Result<Self> {
        Self::open_adapter(&choose(wanted)?, wanted)
    }

    /// Opens the same adapter anew, after the device was lost.
    ///
    /// # Errors
    ///
    /// As [`Gpu::open`].
    pub fn reopen(&self) -> Result<Self> {
        Self::open(self.wanted.as_deref().or(Some(self.adapter.name.as_str())))
    }

    /// Opens an adapter of [`adapters`].
    ///
    /// # Errors
    ///
    /// [`Error::DeviceLost`] where it does not open.
    pub fn open_adapter(adapter: &wgpu::Adapter, wanted: Option<&str>) -> Result<Self> {
        let optional = Features::PASSTHROUGH_SHADERS | Features::SHADER_F64;
        let features = adapter.features() & optional;
        #[expect(unsafe_code, reason = "passthrough of SPIR-V counts as experimental")]
        // SAFETY: the only SPIR-V passed through is naga's own, validated, with decorations.
        let experimental = unsafe { wgpu::ExperimentalFeatures::enabled() };
        let limits = adapter.limits();
        let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("rayproof"),
            required_features: features,
            required_limits: limits.clone(),
            experimental_features: experimental,
            ..Default::default()
        }))
        .map_err(|error| Error::DeviceLost(error.to_string()))?;
        let vulkan = adapter.get_info().backend == wgpu::Backend::Vulkan;
        let mut gpu = Self {
            adapter: AdapterDescription::of(adapter),
            arithmetic: Arithmetic::default(),
            limits,
            device,
            queue,
            wanted: wanted.map(str::to_string),
            exact: vulkan && features.contains(Features::PASSTHROUGH_SHADERS),
            troubles: Arc::default(),
        };
        gpu.watch_for_troubles();
        gpu.arithmetic = measure_arithmetic(&gpu)?;
        Ok(gpu)
    }

    /// Whether float operations are kept as written, so that pictures can be
    /// bit-identical to the CPU's.
    pub fn is_exact(&self) -> bool {
        self.exact
    }

    /// Whether pictures should equal the CPU's bit for bit: operations are kept as
    /// written, and each rounds as Rust's.
    pub fn is_bit_exact(&self) -> bool {
        self.exact && self.arithmetic.is_exact()
    }

    /// Whether the device computes in f64 too.
    pub fn has_f64(&self) -> bool {
        self.device.features().contains(Features::SHADER_F64)
    }

    /// From here on, shaders are compiled by the driver as it likes, as on a device
    /// without passthrough; the arithmetic is measured anew.
    ///
    /// # Errors
    ///
    /// [`Error::DeviceLost`] when the device is lost.
    pub fn give_up_exactness(&mut self) -> Result<()> {
        self.exact = false;
        self.arithmetic = measure_arithmetic(self)?;
        Ok(())
    }

    /// Makes the device unusable, as a crash of the driver would: for tests of
    /// what happens then.
    pub fn destroy(&self) {
        self.device.destroy();
    }

    /// Keeps wgpu from panicking on an error, and notes it.
    fn watch_for_troubles(&self) {
        let troubles = Arc::clone(&self.troubles);
        self.device
            .on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
                troubles
                    .errors
                    .lock()
                    .unwrap_or_else(|e| e.into_inner())
                    .push(error.to_string());
            }));
        let troubles = Arc::clone(&self.troubles);
        self.device
            .set_device_lost_callback(move |reason, message| {
                let text = format!("{message} ({reason:?})");
                *troubles.lost.lock().unwrap_or_else(|e| e.into_inner()) = Some(text);
            });
    }

    /// Waits until the device has done all that was submitted.
    ///
    /// # Errors
    ///
    /// [`Error::DeviceLost`] when it is lost or does not answer in time,
    /// [`Error::Shader`] when wgpu refused something.
    pub(super) fn wait(&self) -> Result<()> {
        let poll = wgpu::PollType::Wait {
            submission_index: None,
            timeout: Some(PATIENCE),
        };
        if let Err(error) = self.device.poll(poll) {
            // Dropping the last handle would wait for the device without end.
            std::mem::forget((self.device.clone(), self.queue.clone()));
            return Err(Error::DeviceLost(error.to_string()));
        }
        if let Some(reason) = &*self.troubles.lost.lock().unwrap_or_else(|e| e.into_inner()) {
            return Err(Error::DeviceLost(reason.clone()));
        }
        match self
            .troubles
            .errors
            .lock()
            .unwrap_or_else(|e| e.into_inner())
            .first()
        {
            Some(error) => Err(Error::Shader(error.clone())),
            None => Ok(()),
        }
    }

    /// Compiles each entry point of a program.
    ///
    /// # Errors
    ///
    /// [`Error::Shader`] when the driver or wgpu refuses it.
    pub(super) fn compile(&self, program: &Program) -> Result<Kernel> {
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let module = self.shader_module(program);
        let layouts = self.bind_group_layouts(program);
        let layout = self
            .device
            .create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: None,
                bind_group_layouts: &layouts.iter().map(Some).collect::<Vec<_>>(),
                immediate_size: 0,
            });
        let pipelines = program
            .entry_points()
            .map(|entry| {
                let pipeline =
                    self.device
                        .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                            label: Some(entry),
                            layout: Some(&layout),
                            module: &module,
                            entry_point: Some(entry),
                            compilation_options: Default::default(),
                            cache: None,
                        });
                (entry.to_string(), pipeline)
            })
            .collect();
        if let Some(error) = pollster::block_on(scope.pop()) {
            return Err(Error::Shader(error.to_string()));
        }
        Ok(Kernel {
            pipelines,
            layouts,
            program_bindings: program.bindings.clone(),
        })
    }

    fn shader_module(&self, program: &Program) -> wgpu::ShaderModule {
        if !self.exact {
            return self
                .device
                .create_shader_module(wgpu::ShaderModuleDescriptor {
                    label: Some("rayproof"),
                    source: wgpu::ShaderSource::Wgsl(program.assembly.wgsl.as_str().into()),
                });
        }
        let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
            label: Some("rayproof"),
            spirv: Some(program.spirv.as_slice().into()),
            entry_points: program
                .module
                .entry_points
                .iter()
                .map(|entry| wgpu::PassthroughShaderEntryPoint {
                    name: entry.name.as_str().into(),
                    workgroup_size: entry.workgroup_size.into(),
                })
                .collect(),
            ..Default::default()
        };
        #[expect(unsafe_code, reason = "the only way to keep NoContraction")]
        // SAFETY: naga validated the module and wrote it with bounds checks.
        unsafe {
            self.device.create_shader_module_passthrough(descriptor)
        }
    }

    fn bind_group_layouts(&self, program: &Program) -> Vec<wgpu::BindGroupLayout> {
        let groups = program
            .bindings
            .iter()
            .map(|binding| binding.group + 1)
            .max()
            .unwrap_or(0);
        (0..groups)
            .map(|group| {
                let entries: Vec<_> = program
                    .bindings
                    .iter()
                    .filter(|binding| binding.group == group)
                    .map(|binding| wgpu::BindGroupLayoutEntry {
                        binding: binding.binding,
                        visibility: wgpu::ShaderStages::COMPUTE,
                        ty: wgpu::BindingType::Buffer {
                            ty: match binding.access {
                                Access::Uniform => wgpu::BufferBindingType::Uniform,
                                Access::Read => {
                                    wgpu::BufferBindingType::Storage { read_only: true }
                                }
                                Access::Write => {
                                    wgpu::BufferBindingType::Storage { read_only: false }
                                }
                            },
                            has_dynamic_offset: false,
                            min_binding_size: None,
                        },
                        count: None,
                    })
                    .collect();
                self.device
                    .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                        label: None,
                        entries: &entries,
                    })
            })
            .collect()
    }
}

/// A compiled program.
pub(super) struct Kernel {
    pipelines: HashMap<String, wgpu::ComputePipeline>,
    layouts: Vec<wgpu::BindGroupLayout>,
    program_bindings: Vec<super::program::Binding>,
}

impl Kernel {
    /// Binds buffers to the variables of one group, by name.
    ///
    /// # Errors
    ///
    /// [`Error::Shader`] where a variable has no buffer: a defect.
    pub(super) fn bind(
        &self,
        gpu: &Gpu,
        group: u32,
        buffers: &HashMap<&'static str, wgpu::Buffer>,
    ) -> Result<wgpu::BindGroup> {
        let mut entries = Vec::new();
        for binding in self
            .program_bindings
            .iter()
            .filter(|binding| binding.group == group)
        {
            let buffer = buffers.get(binding.name.as_str()).ok_or_else(|| {
                Error::Shader(format!("no buffer for the variable `{}`", binding.name))
            })?;
            entries.push(wgpu::BindGroupEntry {
                binding: binding.binding,
                resource: buffer.as_entire_binding(),
            });
        }
        Ok(gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.layouts[group as usize],
            entries: &entries,
        }))
    }

    /// Runs one entry point over `workgroups`, and waits for it.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn run(
        &self,
        gpu: &Gpu,
        entry: &str,
        groups: &[&wgpu::BindGroup],
        workgroups: [u32; 2],
    ) -> Result<()> {
        let pipeline = self
            .pipelines
            .get(entry)
            .ok_or_else(|| Error::Shader(format!("no entry point `{entry}`")))?;
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(pipeline);
            for (index, group) in groups.iter().enumerate() {
                pass.set_bind_group(index as u32, *group, &[]);
            }
            pass.dispatch_workgroups(workgroups[0], workgroups[1], 1);
        }
        gpu.queue.submit([encoder.finish()]);
        gpu.wait()
    }
}

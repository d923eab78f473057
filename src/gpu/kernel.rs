//! A program on a device: compiled, its buffers bound, run.

use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard};

use super::device::Gpu;
use super::program::{Access, Binding, Program, Source};
use super::source::Assembly;
use super::timestamps::Clock;
use crate::error::{Error, Result};
use crate::tier::Width;

/// Programs that are kept at most.
const MOST_KEPT: usize = 64;

/// Compiled programs, by their text and width: scenes that call for the same shader share it.
#[derive(Debug, Default)]
pub(super) struct Kernels(Mutex<Vec<Kept>>);

/// A program's text, how wide its numbers are, and what it was compiled to.
type Kept = ((String, Width), Kernel);

impl Kernels {
    fn kept(&self) -> MutexGuard<'_, Vec<Kept>> {
        self.0.lock().unwrap_or_else(|error| error.into_inner())
    }

    /// Forgets them all.
    pub(super) fn clear(&self) {
        self.kept().clear();
    }
}

impl Gpu {
    /// The program of these files, compiled if it is not at hand.
    ///
    /// # Errors
    ///
    /// As [`Program::in_width`] and [`Gpu::compile`].
    pub(super) fn kernel(&self, files: &[Source], width: Width) -> Result<Kernel> {
        let key = (Assembly::join(files).wgsl, width);
        let of_key = |(other, _): &Kept| *other == key;
        if let Some((_, kernel)) = self.kernels.kept().iter().find(|kept| of_key(kept)) {
            return Ok(kernel.clone());
        }
        let program = if self.adapter.misplaces_uniforms() && files.iter().any(takes_samples) {
            Program::without_uniforms(files, width)?
        } else {
            Program::in_width(files, width)?
        };
        let kernel = self.compile(&program)?;
        let mut kept = self.kernels.kept();
        if kept.len() == MOST_KEPT {
            kept.remove(0);
        }
        kept.push((key, kernel.clone()));
        Ok(kernel)
    }

    /// Compiles each entry point of a program.
    ///
    /// # Errors
    ///
    /// [`Error::Limit`] when the device binds too few buffers, [`Error::Shader`] when
    /// the driver or wgpu refuses the program.
    pub(super) fn compile(&self, program: &Program) -> Result<Kernel> {
        let storage = program
            .bindings
            .iter()
            .filter(|b| matches!(b.access, Access::Read | Access::Write))
            .count();
        let most = self.limits.max_storage_buffers_per_shader_stage as usize;
        if storage > most {
            return Err(Error::Limit(format!(
                "the scene calls for {storage} storage buffers; {} binds {most}",
                self.adapter.name
            )));
        }
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
        if !self.is_exact() {
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
        // SAFETY: naga validated and wrote the module; its indices come from the host's tables.
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
                        ty: binding_type(binding.access),
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

/// Whether a shader with this file takes samples: it decides a lot by uniforms.
fn takes_samples(file: &Source) -> bool {
    file.name == "samples.wgsl"
}

fn binding_type(access: Access) -> wgpu::BindingType {
    let buffer = |ty| wgpu::BindingType::Buffer {
        ty,
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    match access {
        Access::Uniform => buffer(wgpu::BufferBindingType::Uniform),
        Access::Read => buffer(wgpu::BufferBindingType::Storage { read_only: true }),
        Access::Write => buffer(wgpu::BufferBindingType::Storage { read_only: false }),
        Access::Texture => wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Uint,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
    }
}

/// A compiled program; a clone is the same one.
#[derive(Debug, Clone)]
pub(super) struct Kernel {
    pipelines: HashMap<String, wgpu::ComputePipeline>,
    layouts: Vec<wgpu::BindGroupLayout>,
    program_bindings: Vec<Binding>,
}

impl Kernel {
    /// Binds buffers and textures to the variables of one group, by name.
    ///
    /// # Errors
    ///
    /// [`Error::Shader`] where a variable has nothing to be bound to: a defect.
    pub(super) fn bind<'r>(
        &self,
        gpu: &Gpu,
        group: u32,
        resource: impl Fn(&str) -> Option<wgpu::BindingResource<'r>>,
    ) -> Result<wgpu::BindGroup> {
        let mut entries = Vec::new();
        for binding in self
            .program_bindings
            .iter()
            .filter(|binding| binding.group == group)
        {
            let resource = resource(&binding.name).ok_or_else(|| {
                Error::Shader(format!("nothing for the variable `{}`", binding.name))
            })?;
            entries.push(wgpu::BindGroupEntry {
                binding: binding.binding,
                resource,
            });
        }
        Ok(gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.layouts[group as usize],
            entries: &entries,
        }))
    }

    /// Runs one entry point over `workgroups`, and waits for it; gives the seconds
    /// that it took by `clock`, or 0 without one.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn run(
        &self,
        gpu: &Gpu,
        entry: &str,
        groups: &[&wgpu::BindGroup],
        workgroups: [u32; 3],
        clock: Option<&Clock>,
    ) -> Result<f64> {
        let pipeline = self
            .pipelines
            .get(entry)
            .ok_or_else(|| Error::Shader(format!("no entry point `{entry}`")))?;
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                label: None,
                timestamp_writes: clock.map(Clock::of_pass),
            });
            pass.set_pipeline(pipeline);
            for (index, group) in groups.iter().enumerate() {
                pass.set_bind_group(index as u32, *group, &[]);
            }
            let [x, y, z] = workgroups;
            pass.dispatch_workgroups(x, y, z);
        }
        if let Some(clock) = clock {
            clock.resolve(&mut encoder);
        }
        gpu.queue.submit([encoder.finish()]);
        gpu.wait()?;
        clock.map_or(Ok(0.0), |clock| clock.seconds(gpu))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn program(number: usize) -> Source {
        let text = format!("@compute @workgroup_size(1) fn entry_{number}() {{}}");
        Source::new("trial.wgsl", text.leak())
    }

    #[test]
    fn a_program_is_compiled_once_and_few_are_kept() {
        let gpu = Gpu::open(None).unwrap();
        let entry = |number: usize, width| {
            let kernel = gpu.kernel(&[program(number)], width).unwrap();
            kernel.pipelines[&format!("entry_{number}")].clone()
        };
        let first = entry(0, Width::Single);
        assert_eq!(entry(0, Width::Single), first);
        // The controls: of another width it is another one, and one of another text too.
        assert_ne!(entry(0, Width::Extended), first);
        for number in 1..MOST_KEPT + 10 {
            entry(number, Width::Single);
        }
        assert_eq!(gpu.kernels.kept().len(), MOST_KEPT);
        assert_ne!(entry(0, Width::Single), first);
        // What does not compile is told each time.
        let broken = Source::new("broken.wgsl", "fn broken() { return 1.0; }");
        for _ in 0..2 {
            let refused = gpu.kernel(&[broken], Width::Single).unwrap_err();
            assert!(refused.to_string().contains("broken.wgsl:1"), "{refused}");
        }
    }
}

//! A shader module: parsed, validated, reflected, as WGSL and as exact SPIR-V.

use naga::back::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{AddressSpace, StorageAccess, TypeInner};

use super::exact::forbid_contraction;
use super::scratch::leave_arrays_unset;
use super::source::Assembly;
pub use super::source::Source;
use super::split::split_reals;
use crate::error::{Error, Result};
use crate::tier::Width;

/// How a shader uses a buffer or a texture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Access {
    /// A small buffer, the same for all invocations.
    Uniform,
    /// Read only.
    Read,
    /// Read and written.
    Write,
    /// A texture, read only.
    Texture,
}

/// A buffer or a texture that a shader names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Binding {
    /// The variable's name.
    pub name: String,
    /// Its `@group`.
    pub group: u32,
    /// Its `@binding`.
    pub binding: u32,
    /// How the shader uses it.
    pub access: Access,
}

/// A compiled shader module.
#[derive(Debug)]
pub struct Program {
    /// The files that it was made of, and their text.
    pub assembly: Assembly,
    /// The parsed module, without what no entry point uses.
    pub module: naga::Module,
    /// The buffers in use, by group and binding.
    pub bindings: Vec<Binding>,
    /// SPIR-V in which no float operation may be contracted or reordered.
    pub spirv: Vec<u32>,
}

impl Program {
    /// Joins, parses, validates and translates shader files.
    ///
    /// # Errors
    ///
    /// [`Error::Shader`] with file and line: a defect of the shader.
    pub fn build(files: &[Source]) -> Result<Self> {
        Self::translate(files, false, false)
    }

    /// The same for geometry of a width: in two f32, each f64 is rewritten as those, by
    /// the functions of `two_float.wgsl`.
    ///
    /// # Errors
    ///
    /// As [`Program::build`], and where a use of f64 cannot be rewritten.
    pub fn in_width(files: &[Source], width: Width) -> Result<Self> {
        Self::translate(files, width == Width::Extended, false)
    }

    /// The same, its uniform buffers but the scene's read as storage buffers: for drivers that
    /// do harm with uniforms by which something is decided, see `docs/wgsl.md`.
    ///
    /// # Errors
    ///
    /// As [`Program::in_width`].
    pub fn without_uniforms(files: &[Source], width: Width) -> Result<Self> {
        Self::translate(files, width == Width::Extended, true)
    }

    fn translate(files: &[Source], split: bool, stored: bool) -> Result<Self> {
        let assembly = Assembly::join(files);
        let mut module = naga::front::wgsl::parse_str(&assembly.wgsl).map_err(|error| {
            let place = error.location(&assembly.wgsl).map(|at| at.offset as usize);
            shader_error(&assembly, place, error.message())
        })?;
        let info = validate(&module, &assembly)?;
        if split {
            module = split_reals(&module, &info).map_err(Error::Shader)?;
            validate(&module, &assembly)?;
        }
        if stored {
            store_uniforms(&mut module);
        }
        // What no entry point reaches is removed, bindings included.
        naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
        let info = validate(&module, &assembly)?;
        let bindings = reflect(&module);
        let spirv = write_spirv(&module, &info, &bindings)?;
        Ok(Self {
            assembly,
            module,
            bindings,
            spirv: forbid_contraction(&leave_arrays_unset(&spirv)),
        })
    }

    /// The names of the entry points.
    pub fn entry_points(&self) -> impl Iterator<Item = &str> {
        self.module
            .entry_points
            .iter()
            .map(|entry| entry.name.as_str())
    }
}

/// Has uniform buffers but the scene's be storage buffers, which are only read.
fn store_uniforms(module: &mut naga::Module) {
    for (_, variable) in module.global_variables.iter_mut() {
        if variable.space == AddressSpace::Uniform && variable.name.as_deref() != Some("scene") {
            variable.space = AddressSpace::Storage {
                access: StorageAccess::LOAD,
            };
        }
    }
}

fn validate(module: &naga::Module, assembly: &Assembly) -> Result<naga::valid::ModuleInfo> {
    Validator::new(ValidationFlags::all(), Capabilities::FLOAT64)
        .validate(module)
        .map_err(|error| {
            let place = error.location(&assembly.wgsl).map(|at| at.offset as usize);
            let mut message = error.as_inner().to_string();
            let mut cause = std::error::Error::source(error.as_inner());
            while let Some(inner) = cause {
                message = format!("{message}: {inner}");
                cause = inner.source();
            }
            shader_error(assembly, place, &message)
        })
}

fn shader_error(assembly: &Assembly, byte: Option<usize>, message: &str) -> Error {
    let place = byte.map(|byte| assembly.place(byte)).unwrap_or_default();
    Error::Shader(format!("{place}: {message}"))
}

/// The buffers of a module, by group and binding.
fn reflect(module: &naga::Module) -> Vec<Binding> {
    let mut bindings: Vec<Binding> = module
        .global_variables
        .iter()
        .filter_map(|(_, variable)| {
            let at = variable.binding?;
            let access = match variable.space {
                AddressSpace::Uniform => Access::Uniform,
                AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => {
                    Access::Write
                }
                AddressSpace::Storage { .. } => Access::Read,
                AddressSpace::Handle => Access::Texture,
                _ => return None,
            };
            let name = variable.name.clone().unwrap_or_default();
            Some(Binding {
                name,
                group: at.group,
                binding: at.binding,
                access,
            })
        })
        .collect();
    bindings.sort_by_key(|binding| (binding.group, binding.binding));
    bindings
}

/// Without bounds checks, naga's default: every index comes from the host's tables,
/// and Vulkan's robust access stands behind it. Loops need no bounding: each runs over
/// a range that the host sets.
fn write_spirv(
    module: &naga::Module,
    info: &naga::valid::ModuleInfo,
    bindings: &[Binding],
) -> Result<Vec<u32>> {
    let mut binding_map = spv::BindingMap::default();
    for binding in bindings {
        // wgpu numbers the bindings of a group from 0 without gaps.
        let number = bindings
            .iter()
            .filter(|other| other.group == binding.group && other.binding < binding.binding)
            .count();
        binding_map.insert(
            naga::ResourceBinding {
                group: binding.group,
                binding: binding.binding,
            },
            spv::BindingInfo {
                descriptor_set: binding.group,
                binding: number as u32,
                binding_array_size: None,
            },
        );
    }
    let options = spv::Options {
        flags: spv::WriterFlags::empty(),
        fake_missing_bindings: false,
        binding_map,
        force_loop_bounding: false,
        ..Default::default()
    };
    spv::write_vec(module, info, &options, None)
        .map_err(|error| Error::Shader(format!("SPIR-V: {error}")))
}

/// A WGSL struct as naga lays it out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StructLayout {
    /// Name and byte offset of each field.
    pub fields: Vec<(String, usize)>,
    /// Bytes from one element of an array to the next.
    pub stride: usize,
}

/// The layout of the WGSL struct `name`, padding fields left out.
pub fn struct_layout(module: &naga::Module, name: &str) -> Option<StructLayout> {
    let (_, ty) = module
        .types
        .iter()
        .find(|(_, ty)| ty.name.as_deref() == Some(name))?;
    let TypeInner::Struct { members, span } = &ty.inner else {
        return None;
    };
    let fields = members
        .iter()
        .map(|member| {
            (
                member.name.clone().unwrap_or_default(),
                member.offset as usize,
            )
        })
        .filter(|(field, _)| !field.starts_with("padding"))
        .collect();
    Some(StructLayout {
        fields,
        stride: *span as usize,
    })
}

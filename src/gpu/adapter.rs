//! The adapters of this machine.

use serde::Serialize;
use wgpu::{Backends, DeviceType};

use crate::error::{Error, Result};

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
    /// Whether the CPU does the work.
    pub fn is_software(&self) -> bool {
        self.kind == "software"
    }

    /// Whether the driver notes in the wrong place by which uniforms something is decided, and
    /// does harm by that: Mesa's lavapipe, see `docs/wgsl.md`.
    pub fn misplaces_uniforms(&self) -> bool {
        self.name.contains("llvmpipe")
    }

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
pub(super) fn choose(wanted: Option<&str>) -> Result<wgpu::Adapter> {
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

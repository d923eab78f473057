//! What traces the rays.

use std::num::NonZeroUsize;

use crate::error::{Error, Result};
use crate::gpu::device::Gpu;
use crate::tier::Accuracy;

/// What traces the rays.
#[derive(Debug)]
pub enum Backend {
    /// The kernel, on so many threads, or on one for each core.
    Cpu(Option<NonZeroUsize>),
    /// The shaders, on an open device.
    Gpu(Box<Gpu>),
}

impl Backend {
    /// The best GPU adapter, software Vulkan included, or the CPU where there is
    /// none.
    ///
    /// # Errors
    ///
    /// When there is an adapter but it does not open.
    pub fn auto() -> Result<Self> {
        match Gpu::open(None) {
            Ok(gpu) => Ok(Self::Gpu(Box::new(gpu))),
            Err(Error::NoAdapter(_)) => Ok(Self::Cpu(None)),
            Err(error) => Err(error),
        }
    }

    /// `cpu` or `gpu`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Cpu(_) => "cpu",
            Self::Gpu(_) => "gpu",
        }
    }

    /// Whether it traces by shaders, out of which effects are left.
    pub fn has_shaders(&self) -> bool {
        matches!(self, Self::Gpu(_))
    }

    /// Why it does not trace with this accuracy, if it does not.
    pub fn lacks(&self, accuracy: Accuracy) -> Option<String> {
        match self {
            Self::Cpu(_) => None,
            Self::Gpu(gpu) => gpu.lacks(accuracy),
        }
    }

    /// For people: which CPU path or which adapter.
    pub fn describe(&self) -> String {
        match self {
            Self::Cpu(_) => "cpu".to_string(),
            Self::Gpu(gpu) => format!("gpu ({})", gpu.adapter.name),
        }
    }
}

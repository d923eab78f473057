//! An open device: its limits, its arithmetic, its troubles.

use std::sync::{Arc, Mutex};
use std::time::Duration;

use wgpu::Features;

use super::adapter::{AdapterDescription, choose};
use super::kernel::Kernels;
use super::selfcheck::{Arithmetic, measure_arithmetic};
use crate::error::{Error, Result};
use crate::tier::Accuracy;

/// How long one dispatch may take before the device counts as lost. Dispatches
/// are sized to take a tenth of a second; a driver that compiles a pipeline on
/// its first use may take some seconds.
const PATIENCE: Duration = Duration::from_secs(60);

/// Why a device did not open. wgpu tells its reasons apart in words only.
fn refusal(error: &wgpu::RequestDeviceError) -> Error {
    let reason = error.to_string();
    if reason.to_lowercase().contains("memory") {
        Error::Limit(format!("the device did not open: {reason}"))
    } else {
        Error::DeviceLost(reason)
    }
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
    f64: bool,
    troubles: Arc<Troubles>,
    pub(super) kernels: Kernels,
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

    /// Opens an adapter of [`super::adapter::adapters`].
    ///
    /// # Errors
    ///
    /// [`Error::DeviceLost`] where it does not open.
    pub fn open_adapter(adapter: &wgpu::Adapter, wanted: Option<&str>) -> Result<Self> {
        let description = AdapterDescription::of(adapter);
        let mut optional =
            Features::PASSTHROUGH_SHADERS | Features::SHADER_F64 | Features::TIMESTAMP_QUERY;
        if description.is_software() {
            // The device's memory is the host's: results are read where they lie.
            optional |= Features::MAPPABLE_PRIMARY_BUFFERS;
        }
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
        .map_err(|error| refusal(&error))?;
        let vulkan = adapter.get_info().backend == wgpu::Backend::Vulkan;
        let mut gpu = Self {
            adapter: description,
            arithmetic: Arithmetic::default(),
            limits,
            device,
            queue,
            wanted: wanted.map(str::to_string),
            exact: vulkan && features.contains(Features::PASSTHROUGH_SHADERS),
            f64: features.contains(Features::SHADER_F64),
            troubles: Arc::default(),
            kernels: Kernels::default(),
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
        self.f64
    }

    /// Why the device does not trace with this accuracy, if it does not.
    pub fn lacks(&self, accuracy: Accuracy) -> Option<String> {
        let name = &self.adapter.name;
        match accuracy {
            Accuracy::Textbook | Accuracy::Robust => None,
            Accuracy::Extended
                if self.is_exact() && self.arithmetic.two_sum && self.arithmetic.two_prod =>
            {
                None
            }
            Accuracy::Extended => {
                let reason = if !self.arithmetic.two_sum {
                    "TwoSum does not give the error of a sum there"
                } else if !self.arithmetic.two_prod {
                    "TwoProd does not give the error of a product there"
                } else {
                    "it takes no SPIR-V that would keep the driver from rearranging sums"
                };
                Some(format!(
                    "`extended` needs exact sums, and {name} has none: {reason}"
                ))
            }
            Accuracy::Double | Accuracy::Adaptive if self.has_f64() => None,
            Accuracy::Double => Some(format!("`double` needs f64, which {name} has not")),
            // Rays in doubt are then traced again in two f32.
            Accuracy::Adaptive => self
                .lacks(Accuracy::Extended)
                .map(|_| format!("`adaptive` needs f64 or exact sums, and {name} has neither")),
        }
    }

    /// Whether the device times its passes.
    pub fn has_clock(&self) -> bool {
        self.device.features().contains(Features::TIMESTAMP_QUERY)
    }

    /// Whether the host may read a storage buffer in place.
    pub(super) fn maps_storage(&self) -> bool {
        let features = self.device.features();
        features.contains(Features::MAPPABLE_PRIMARY_BUFFERS)
    }

    /// From here on, shaders are compiled by the driver as it likes, as on a device
    /// without passthrough; the arithmetic is measured anew.
    ///
    /// # Errors
    ///
    /// [`Error::DeviceLost`] when the device is lost.
    pub fn give_up_exactness(&mut self) -> Result<()> {
        self.exact = false;
        self.kernels.clear();
        self.arithmetic = measure_arithmetic(self)?;
        Ok(())
    }

    /// From here on, no shader computes in f64, as on a device without it; the arithmetic is
    /// measured anew.
    ///
    /// # Errors
    ///
    /// [`Error::DeviceLost`] when the device is lost.
    pub fn give_up_f64(&mut self) -> Result<()> {
        self.f64 = false;
        self.kernels.clear();
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
}

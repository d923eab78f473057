//! What is measured: volumes on a backend.

use std::num::NonZeroUsize;
use std::time::Instant;

use super::BoundedScene;
use rayproof::count::Counters;
use rayproof::cpu;
use rayproof::error::{Error, Result};
use rayproof::frame::Frame;
use rayproof::gpu::device::Gpu;
use rayproof::gpu::render::{self as gpu, Portions, Seconds};
use rayproof::layout::Pixel;
use rayproof::measure::{Spread, Turn};
use rayproof::watch::Watch;

/// A backend with a scene prepared on it.
pub(super) enum Tracer<'a> {
    Cpu(cpu::Prepared<'a, f32>),
    Gpu(Box<OnGpu<'a>>),
}

/// A scene prepared on a device.
pub(super) struct OnGpu<'a> {
    device: &'a Gpu,
    /// As pictures are traced.
    prepared: gpu::Prepared<'a, f32>,
    /// With passes that are timed, where the device has a clock.
    timed: Option<gpu::Prepared<'a, f32>>,
}

impl<'a> Tracer<'a> {
    pub(super) fn on_gpu(device: &'a Gpu, scene: &'a BoundedScene) -> Result<Self> {
        let prepare = |time| {
            let portions = Portions {
                time,
                ..Portions::default()
            };
            gpu::Prepared::new(device, &scene.flat, portions)
        };
        let timed = device.has_clock().then(|| prepare(true)).transpose()?;
        Ok(Self::Gpu(Box::new(OnGpu {
            device,
            prepared: prepare(false)?,
            timed,
        })))
    }

    /// Traces a picture.
    pub(super) fn run(
        &mut self,
        watch: &dyn Watch,
        keep: &mut dyn FnMut(u32, &[Pixel]),
    ) -> Result<()> {
        match self {
            Self::Cpu(prepared) => prepared.run(watch, keep),
            Self::Gpu(on_gpu) => on_gpu.prepared.run(watch, keep),
        }
    }

    /// The seconds that the passes of a picture take by the device's clock, if it has one.
    fn time_passes(&mut self, watch: &dyn Watch) -> Result<Option<Seconds>> {
        let Self::Gpu(on_gpu) = self else {
            return Ok(None);
        };
        let Some(timed) = &mut on_gpu.timed else {
            return Ok(None);
        };
        timed.run(watch, &mut |_, _| {})?;
        Ok(timed.seconds())
    }

    /// Counts what the rays test, in a run of its own.
    pub(super) fn count(&self, scene: &BoundedScene, watch: &dyn Watch) -> Result<Counters> {
        let map = match self {
            Self::Cpu(prepared) => {
                cpu::count(&scene.flat, NonZeroUsize::new(prepared.threads()), watch)
            }
            Self::Gpu(on_gpu) => gpu::count(on_gpu.device, &scene.flat, watch),
        };
        map.map(|map| map.sum())
    }
}

/// What is measured: volumes on a backend.
pub(super) struct Case<'a> {
    pub(super) scene: &'a BoundedScene,
    pub(super) tracer: Tracer<'a>,
    /// Pixels by which its worst picture differed from the first case's.
    pub(super) different_pixels: u64,
    /// Of each run that counts, on a device with a clock.
    pub(super) device_seconds: Vec<Seconds>,
    pub(super) counters: Option<Counters>,
}

impl<'a> Case<'a> {
    pub(super) fn new(scene: &'a BoundedScene, tracer: Tracer<'a>) -> Self {
        Self {
            scene,
            tracer,
            different_pixels: 0,
            device_seconds: Vec::new(),
            counters: None,
        }
    }

    pub(super) fn backend(&self) -> &'static str {
        match self.tracer {
            Tracer::Cpu(_) => "cpu",
            Tracer::Gpu(_) => "gpu",
        }
    }

    pub(super) fn adapter(&self) -> Option<&str> {
        match &self.tracer {
            Tracer::Cpu(_) => None,
            Tracer::Gpu(on_gpu) => Some(&on_gpu.device.adapter.name),
        }
    }

    pub(super) fn threads(&self) -> Option<usize> {
        match &self.tracer {
            Tracer::Cpu(prepared) => Some(prepared.threads()),
            Tracer::Gpu(_) => None,
        }
    }

    pub(super) fn name(&self) -> String {
        let threads = match self.threads() {
            Some(threads) => format!(" on {threads} threads"),
            None => String::new(),
        };
        format!("{}{threads}, {}", self.backend(), self.scene.bounds.name())
    }

    /// The median time of building the volumes, what this backend makes of them included.
    pub(super) fn build_ms(&self) -> f64 {
        let own = match &self.tracer {
            Tracer::Cpu(prepared) => prepared.build_time().as_secs_f64(),
            Tracer::Gpu(_) => 0.0,
        };
        (self.scene.build.median + own) * 1e3
    }

    /// What the progress of a run is called.
    pub(super) fn label(&self, turn: Turn) -> String {
        let run = if turn.warm_up { "warm-up" } else { "run" };
        format!("{}, {run} {}", self.name(), turn.number)
    }

    /// The median of the passes in which hits are found, by the device's clock.
    pub(super) fn search_ms(&self) -> Option<f64> {
        self.device_ms(|seconds| seconds.trace)
    }

    /// The median of a part of the device's seconds, in milliseconds.
    pub(super) fn device_ms(&self, part: fn(&Seconds) -> f64) -> Option<f64> {
        let seconds: Vec<f64> = self.device_seconds.iter().map(part).collect();
        (!seconds.is_empty()).then(|| Spread::of(&seconds).median * 1e3)
    }

    /// Traces a picture into `frame` and gives the seconds that it took, reading
    /// it back included.
    pub(super) fn trace(
        &mut self,
        turn: Turn,
        frame: &mut Frame,
        watch: &dyn Watch,
    ) -> Result<f64> {
        let mut complete = true;
        let started = Instant::now();
        self.tracer.run(watch, &mut |row, pixels| {
            complete &= frame.keep_rows(row, pixels);
        })?;
        let seconds = started.elapsed().as_secs_f64();
        let by_device = self.tracer.time_passes(watch)?;
        // What warmed up does not count.
        if turn.warm_up || turn.number == 1 {
            self.device_seconds.clear();
        }
        self.device_seconds.extend(by_device);
        if complete {
            return Ok(seconds);
        }
        Err(Error::Limit(format!(
            "some rays meet too many volumes of `{}`: add `--bounds none`",
            self.scene.bounds.name()
        )))
    }
}

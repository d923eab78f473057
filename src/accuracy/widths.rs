//! A scene in the numbers of every tier.

use super::lengths::{of_their_own, ordinary};
use crate::bounds::{self, Bounds};
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::found::Found;
use crate::gpu::render::{Portions, Seconds};
use crate::kernel::camera::Ray;
use crate::kernel::real::Real;
use crate::layout::Pixel;
use crate::render::Backend;
use crate::tier::{Accuracy, Bounded, Double, Extended, Robust, Textbook};
use crate::watch::Watch;
use crate::{cpu, gpu};

/// A scene in the numbers of every tier, with its volumes.
pub struct Widths {
    pub(crate) textbook: Flat<Textbook>,
    pub(crate) robust: Flat<Robust>,
    pub(crate) extended: Flat<Extended>,
    /// In f64, from which the others are rounded.
    pub double: Flat<Double>,
    pub(crate) bounded: Flat<Bounded>,
}

/// A scene ready to be traced, any number of times.
pub trait Tracer {
    /// Traces a picture. Its rows are handed to `keep`, from top to bottom, together with
    /// the number of their first row.
    ///
    /// # Errors
    ///
    /// As [`cpu::Prepared::run`] and [`gpu::render::Prepared::run`].
    fn run(&mut self, watch: &dyn Watch, keep: &mut dyn FnMut(u32, &[Pixel])) -> Result<()>;

    /// How many rays of the last picture were traced a second time.
    fn retraced(&self) -> u64;

    /// How long the last picture's passes took by the device's clock, where they are timed.
    fn seconds(&self) -> Option<Seconds>;
}

impl<R: Real> Tracer for cpu::Prepared<'_, R> {
    fn run(&mut self, watch: &dyn Watch, keep: &mut dyn FnMut(u32, &[Pixel])) -> Result<()> {
        cpu::Prepared::run(self, watch, keep)
    }

    fn retraced(&self) -> u64 {
        cpu::Prepared::retraced(self)
    }

    fn seconds(&self) -> Option<Seconds> {
        None
    }
}

impl<R: Real> Tracer for gpu::render::Prepared<'_, R> {
    fn run(&mut self, watch: &dyn Watch, keep: &mut dyn FnMut(u32, &[Pixel])) -> Result<()> {
        gpu::render::Prepared::run(self, watch, keep)
    }

    fn retraced(&self) -> u64 {
        gpu::render::Prepared::retraced(self)
    }

    fn seconds(&self) -> Option<Seconds> {
        gpu::render::Prepared::seconds(self)
    }
}

impl Widths {
    /// Of a flattened scene. The tiers share their volumes, but for the textbook's, which
    /// are not padded.
    pub fn of(mut double: Flat<Double>, bounds: Bounds) -> Self {
        let mut textbook = double.converted::<Textbook>();
        bounds::bound(&mut textbook, bounds);
        bounds::bound(&mut double, bounds);
        Self {
            textbook,
            robust: double.converted(),
            extended: double.converted(),
            bounded: double.converted(),
            double,
        }
    }

    /// Makes a picture in a tier ready; its passes are timed by the device if that is asked
    /// for, and then hits are found and coloured in passes apart.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] where the backend lacks the tier, [`Error::Limit`] where it has no
    /// room for the scene.
    pub fn tracer<'a>(
        &'a self,
        backend: &'a Backend,
        accuracy: Accuracy,
        time: bool,
    ) -> Result<Box<dyn Tracer + 'a>> {
        let portions = Portions {
            time,
            ..Portions::default()
        };
        if let Some(reason) = backend.lacks(accuracy) {
            return Err(Error::Usage(reason));
        }
        match accuracy {
            Accuracy::Textbook => plain(backend, &self.textbook, portions),
            Accuracy::Robust => plain(backend, &self.robust, portions),
            Accuracy::Extended => plain(backend, &self.extended, portions),
            Accuracy::Double => plain(backend, &self.double, portions),
            // So many primitives by brute force, or lights: in f64 from the beginning.
            Accuracy::Adaptive if !gpu::render::may_retrace(&self.double, portions) => {
                match backend {
                    Backend::Gpu(gpu) if !gpu.has_f64() => plain(backend, &self.extended, portions),
                    _ => plain(backend, &self.double, portions),
                }
            }
            Accuracy::Adaptive => Ok(match backend {
                Backend::Cpu(threads) => {
                    let prepared = cpu::Prepared::new(&self.bounded, *threads)?;
                    Box::new(prepared.with_second(&self.double))
                }
                Backend::Gpu(gpu) => Box::new(gpu::render::adaptive(
                    gpu,
                    &self.bounded,
                    &self.double,
                    portions,
                )?),
            }),
        }
    }

    /// Finds the closest hit of each ray in a tier, and tells how many rays were traced a
    /// second time. A direction may be of any length; only the textbook takes it as it comes.
    ///
    /// # Errors
    ///
    /// As [`Widths::tracer`].
    pub fn trace_rays(
        &self,
        backend: &Backend,
        accuracy: Accuracy,
        rays: &[Ray<f32>],
    ) -> Result<(Vec<Found>, u64)> {
        if let Some(reason) = backend.lacks(accuracy) {
            return Err(Error::Usage(reason));
        }
        let is_tamed = accuracy != Accuracy::Textbook;
        let Some((ordinary, powers)) = is_tamed.then(|| ordinary(rays)).flatten() else {
            return self.trace_as_they_are(backend, accuracy, rays);
        };
        let (mut found, retraced) = self.trace_as_they_are(backend, accuracy, &ordinary)?;
        of_their_own(&mut found, &powers);
        Ok((found, retraced))
    }

    fn trace_as_they_are(
        &self,
        backend: &Backend,
        accuracy: Accuracy,
        rays: &[Ray<f32>],
    ) -> Result<(Vec<Found>, u64)> {
        let found = match (accuracy, backend) {
            (Accuracy::Textbook, _) => list(backend, &self.textbook, rays),
            (Accuracy::Robust, _) => list(backend, &self.robust, rays),
            (Accuracy::Extended, _) => list(backend, &self.extended, rays),
            (Accuracy::Double, _) => list(backend, &self.double, rays),
            (Accuracy::Adaptive, Backend::Cpu(threads)) => {
                return cpu::rays::trace_adaptively(&self.bounded, &self.double, rays, *threads);
            }
            (Accuracy::Adaptive, Backend::Gpu(gpu)) => {
                return gpu::rays::trace_adaptively(gpu, &self.bounded, &self.double, rays);
            }
        };
        Ok((found?, 0))
    }
}

fn plain<'a, R: Real>(
    backend: &'a Backend,
    flat: &'a Flat<R>,
    portions: Portions,
) -> Result<Box<dyn Tracer + 'a>> {
    Ok(match backend {
        Backend::Cpu(threads) => Box::new(cpu::Prepared::new(flat, *threads)?),
        Backend::Gpu(gpu) => Box::new(gpu::render::Prepared::new(gpu, flat, portions)?),
    })
}

fn list<R: Real>(backend: &Backend, flat: &Flat<R>, rays: &[Ray<f32>]) -> Result<Vec<Found>> {
    match backend {
        Backend::Cpu(threads) => cpu::rays::trace_rays(flat, rays, *threads),
        Backend::Gpu(gpu) => gpu::rays::trace_rays(gpu, flat, rays),
    }
}

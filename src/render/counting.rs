//! What the rays of a picture test.

use super::{Accuracy, Backend, Settings, bounded};
use crate::bounds;
use crate::count::CountMap;
use crate::error::{Error, Result};
use crate::kernel::real::Real;
use crate::scene::Scene;
use crate::tier::{Bounded, Double, Extended, Robust, Textbook};
use crate::watch::Watch;
use crate::{cpu, gpu};

/// Counts what each ray of a picture tests, in a pass of its own: with a shader that
/// counts, or on the CPU with the arithmetic of the shader. Of the adaptive tier, the
/// first pass is counted.
///
/// # Errors
///
/// As [`super::render`].
pub fn count(
    scene: &Scene,
    backend: &Backend,
    settings: impl Into<Settings>,
    watch: &dyn Watch,
) -> Result<CountMap> {
    scene.validate()?;
    let settings = settings.into();
    if let Some(reason) = backend.lacks(settings.accuracy) {
        return Err(Error::Usage(reason));
    }
    match settings.accuracy {
        Accuracy::Textbook => count_in::<Textbook>(scene, backend, settings, watch),
        Accuracy::Robust => count_in::<Robust>(scene, backend, settings, watch),
        Accuracy::Extended => count_in::<Extended>(scene, backend, settings, watch),
        Accuracy::Double => count_in::<Double>(scene, backend, settings, watch),
        Accuracy::Adaptive => count_in::<Bounded>(scene, backend, settings, watch),
    }
}

fn count_in<R: Real>(
    scene: &Scene,
    backend: &Backend,
    settings: Settings,
    watch: &dyn Watch,
) -> Result<CountMap> {
    let flat = bounded::<R>(scene, settings);
    match backend {
        Backend::Cpu(threads) => cpu::count(&flat, *threads, watch),
        Backend::Gpu(gpu) => gpu::render::count(gpu, &flat, watch),
    }
}

/// Of each pixel, whether the outline of a volume runs through it, see
/// [`bounds::outlines`].
///
/// # Errors
///
/// The faults of the scene.
pub fn outlines(scene: &Scene, settings: impl Into<Settings>) -> Result<Vec<bool>> {
    scene.validate()?;
    Ok(bounds::outlines(&bounded::<f32>(scene, settings.into())))
}

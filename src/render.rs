//! From a scene to a picture: flatten, trace, collect.

mod backend;
mod counting;
mod stats;

use std::time::Instant;

pub use self::backend::Backend;
pub use self::counting::{count, outlines};
pub use self::stats::{Rendering, Stats};
use crate::bounds::{self, Bounds};
use crate::effects::{EffectSet, effects_of, takes_samples};
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::flatten::flatten;
use crate::frame::Frame;
use crate::gpu::device::Gpu;
use crate::gpu::render::{Portions, adaptive, may_retrace};
use crate::kernel::real::Real;
use crate::layout::Pixel;
use crate::samples::{Enough, Preview, Taken, take_samples};
use crate::scene::Scene;
pub use crate::tier::Accuracy;
use crate::tier::{Bounded, Double, Extended, Robust, Textbook, Width};
use crate::watch::Watch;
use crate::{cpu, gpu};

/// How to render.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Settings {
    /// Formulas and width of the geometry.
    pub accuracy: Accuracy,
    /// Bounding volumes; they change the time, never the picture.
    pub bounds: Bounds,
    /// Effects that are in the shaders though the scene may not call for them; they change
    /// the time, never the picture.
    pub forced: EffectSet,
}

impl From<Accuracy> for Settings {
    fn from(accuracy: Accuracy) -> Self {
        Self {
            accuracy,
            ..Self::default()
        }
    }
}

/// Renders a scene.
///
/// A GPU that is lost on the way is opened anew, once, and the picture begun
/// again.
///
/// # Errors
///
/// [`Error::Usage`] when the scene is not valid or the backend lacks the
/// accuracy, [`Error::Limit`], [`Error::DeviceLost`], [`Error::Interrupted`].
///
/// # Examples
///
/// ```
/// use rayproof::render::{Accuracy, Backend, render};
/// use rayproof::scene::Scene;
/// use rayproof::watch::Unwatched;
///
/// let scene = Scene::load("assets/scenes/seed-spheres.toml")?.with_size(64, 64);
/// let picture = render(&scene, &Backend::Cpu(None), Accuracy::Robust, &Unwatched)?;
/// assert_eq!(picture.stats.primitives, 72);
/// # Ok::<(), rayproof::Error>(())
/// ```
pub fn render(
    scene: &Scene,
    backend: &Backend,
    settings: impl Into<Settings>,
    watch: &dyn Watch,
) -> Result<Rendering> {
    render_until(scene, backend, settings, watch, Until::default())
}

/// When a picture that is made of samples has enough of them, and what is shown on the way.
#[derive(Default)]
pub struct Until<'a> {
    /// When it ends before it has all its samples.
    pub enough: Enough,
    /// What is shown on the way.
    pub preview: Option<Preview<'a>>,
}

/// As [`render`]; a picture that is made of samples may end before it has all of them, or be
/// shown on the way.
///
/// # Errors
///
/// As [`render`], and those of the preview.
pub fn render_until(
    scene: &Scene,
    backend: &Backend,
    settings: impl Into<Settings>,
    watch: &dyn Watch,
    until: Until<'_>,
) -> Result<Rendering> {
    scene.validate()?;
    let settings = settings.into();
    if let Some(reason) = backend.lacks(settings.accuracy) {
        return Err(Error::Usage(reason));
    }
    match settings.accuracy {
        Accuracy::Textbook => plainly::<Textbook>(scene, backend, settings, watch, until),
        Accuracy::Robust => plainly::<Robust>(scene, backend, settings, watch, until),
        Accuracy::Extended => plainly::<Extended>(scene, backend, settings, watch, until),
        Accuracy::Double => plainly::<Double>(scene, backend, settings, watch, until),
        Accuracy::Adaptive => {
            run::<Double>(scene, backend, settings, watch, until, &mut |flat, keep| {
                if !may_retrace(flat, Portions::default()) {
                    // So many primitives by brute force, or lights: in f64 from the beginning.
                    trace_plainly(flat, backend, settings, watch, keep)?;
                    return Ok(u64::from(flat.size[0]) * u64::from(flat.size[1]));
                }
                let first = flat.converted::<Bounded>();
                match backend {
                    Backend::Cpu(threads) => {
                        let prepared = cpu::Prepared::new(&first, *threads)?.with_second(flat);
                        prepared.run(watch, keep)?;
                        Ok(prepared.retraced())
                    }
                    Backend::Gpu(gpu) => on_gpu(gpu, &mut |gpu| {
                        let mut prepared = adaptive(gpu, &first, flat, portions_of(settings))?;
                        prepared.run(watch, keep)?;
                        Ok(prepared.retraced())
                    }),
                }
            })
        }
    }
}

/// How a device is asked for what the settings say.
fn portions_of(settings: Settings) -> Portions {
    Portions {
        forced: settings.forced,
        ..Portions::default()
    }
}

/// Renders in numbers of one kind.
fn plainly<R: Real>(
    scene: &Scene,
    backend: &Backend,
    settings: Settings,
    watch: &dyn Watch,
    until: Until<'_>,
) -> Result<Rendering> {
    run::<R>(scene, backend, settings, watch, until, &mut |flat, keep| {
        trace_plainly(flat, backend, settings, watch, keep)?;
        Ok(0)
    })
}

fn trace_plainly<R: Real>(
    flat: &Flat<R>,
    backend: &Backend,
    settings: Settings,
    watch: &dyn Watch,
    keep: &mut KeepRows<'_>,
) -> Result<()> {
    match backend {
        Backend::Cpu(threads) => cpu::render(flat, *threads, watch, keep),
        Backend::Gpu(gpu) => on_gpu(gpu, &mut |gpu| {
            let portions = portions_of(settings);
            if is_too_wide::<R>(gpu) {
                let flat = flat.converted::<Extended>();
                return gpu::render::render(gpu, &flat, portions, watch, keep);
            }
            gpu::render::render(gpu, flat, portions, watch, keep)
        }),
    }
}

/// Whether a device has no numbers of this width: in the adaptive tier two f32 then stand for an
/// f64.
fn is_too_wide<R: Real>(gpu: &Gpu) -> bool {
    R::WIDTH == Width::Double && !gpu.has_f64()
}

/// A valid scene, flattened, with its volumes.
pub(crate) fn bounded<R: Real>(scene: &Scene, settings: Settings) -> Flat<R> {
    let mut flat = flatten::<R>(scene);
    bounds::bound(&mut flat, settings.bounds);
    flat
}

/// Takes rows of pixels, with the number of their first row.
type KeepRows<'a> = dyn FnMut(u32, &[Pixel]) + 'a;

/// Traces a flattened scene, and tells how many rays it traced a second time.
type Trace<'a, R> = dyn FnMut(&Flat<R>, &mut KeepRows<'_>) -> Result<u64> + 'a;

/// Flattens, traces and collects, in one width.
fn run<R: Real>(
    scene: &Scene,
    backend: &Backend,
    settings: Settings,
    watch: &dyn Watch,
    until: Until<'_>,
    trace: &mut Trace<'_, R>,
) -> Result<Rendering> {
    let started = Instant::now();
    let mut flat = flatten::<R>(scene);
    let build_started = Instant::now();
    let mut bounds = settings.bounds;
    bounds::bound(&mut flat, bounds);
    let build_ms = milliseconds(build_started);
    let mut frame = Frame::new(flat.size[0], flat.size[1])?;
    let trace_started = Instant::now();
    let samples = takes_samples(&flat.counts(), settings.forced);
    let mut taken = Taken {
        samples: 1,
        ..Taken::default()
    };
    let mut retraced = if samples {
        taken = sample(&flat, backend, settings, &mut frame, watch, until)?;
        Some(0)
    } else {
        trace_and_keep(&flat, trace, &mut frame)?
    };
    if retraced.is_none() {
        tracing::warn!("some rays meet too many volumes: tracing without volumes");
        bounds = Bounds::None;
        bounds::bound(&mut flat, bounds);
        retraced = trace_and_keep(&flat, trace, &mut frame)?;
    }
    let trace_ms = milliseconds(trace_started);
    let rays = u64::from(frame.width) * u64::from(frame.height) * u64::from(taken.samples);
    let adapter = match backend {
        Backend::Cpu(_) => None,
        Backend::Gpu(gpu) => Some(&gpu.adapter),
    };
    let stats = Stats {
        backend: backend.name(),
        adapter: adapter.map(|adapter| adapter.name.clone()),
        driver: adapter.map(|adapter| adapter.driver.clone()),
        width: frame.width,
        height: frame.height,
        samples: taken.samples,
        noise: taken.noise,
        faults: taken.faults,
        first_fault: taken.first_fault,
        accuracy: settings.accuracy,
        bounds,
        effects: effects_of(&flat.counts(), samples),
        primitives: flat.primitives(),
        seconds: started.elapsed().as_secs_f64(),
        trace_ms,
        build_ms,
        rays,
        retraced: retraced.filter(|_| settings.accuracy == Accuracy::Adaptive && !samples),
        mrays_per_s: rays as f64 / trace_ms.max(1e-6) / 1e3,
        device_bytes: flat.bytes(),
        counters: None,
    };
    Ok(Rendering { frame, stats })
}

/// Traces all rays, and tells how many of them twice; none if some were given up on their
/// way through a tree.
fn trace_and_keep<R: Real>(
    flat: &Flat<R>,
    trace: &mut Trace<'_, R>,
    frame: &mut Frame,
) -> Result<Option<u64>> {
    let mut complete = true;
    let retraced = trace(flat, &mut |row, pixels| {
        complete &= frame.keep_rows(row, pixels);
    })?;
    Ok(complete.then_some(retraced))
}

/// Takes the samples of a picture that is made of them.
fn sample<R: Real>(
    flat: &Flat<R>,
    backend: &Backend,
    settings: Settings,
    frame: &mut Frame,
    watch: &dyn Watch,
    mut until: Until<'_>,
) -> Result<Taken> {
    let enough = until.enough;
    match backend {
        Backend::Cpu(threads) => {
            let mut sampler = cpu::sampled::Sampled::new(flat, *threads)?;
            take_samples(
                &mut sampler,
                frame,
                flat.samples,
                enough,
                watch,
                until.preview,
            )
        }
        Backend::Gpu(gpu) => on_gpu(gpu, &mut |gpu| {
            let portions = portions_of(settings);
            let preview = until.preview.as_mut().map(Preview::again);
            if is_too_wide::<R>(gpu) {
                let flat = flat.converted::<Extended>();
                let mut sampler = gpu::sampled::Sampled::new(gpu, &flat, portions)?;
                return take_samples(&mut sampler, frame, flat.samples, enough, watch, preview);
            }
            let mut sampler = gpu::sampled::Sampled::new(gpu, flat, portions)?;
            take_samples(&mut sampler, frame, flat.samples, enough, watch, preview)
        }),
    }
}

/// Traces on the GPU; a device that is lost on the way is opened anew, once.
fn on_gpu<T>(gpu: &Gpu, trace: &mut dyn FnMut(&Gpu) -> Result<T>) -> Result<T> {
    let outcome = trace(gpu);
    let Err(Error::DeviceLost(reason)) = outcome else {
        return outcome;
    };
    tracing::warn!("the device was lost ({reason}); opening it anew");
    trace(&gpu.reopen()?)
}

fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}

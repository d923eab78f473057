//! One pixel explained: what its ray meets in each tier and in truth, and why one shape wins.
//!
//! [`explain`] gathers the facts. `seen` is a tier's own view of the ray, `truth` the
//! oracle's; `candidates` puts both side by side, shape by shape; `path` follows the volumes
//! to the winner; `words` and `textbook` say in a sentence how a tier came to its answer.

mod candidates;
mod path;
mod seen;
mod textbook;
mod truth;
mod words;

#[cfg(test)]
mod tests;

use serde::Serialize;

use self::candidates::candidates;
use self::path::path_to;
use self::seen::{Seen, see};
use self::truth::Truths;
use self::words::Story;
use crate::accuracy::Widths;
use crate::accuracy::errors::verdict;
use crate::bounds::Bounds;
use crate::count::Counters;
use crate::error::{Error, Result};
use crate::flatten::flatten_with_ids;
use crate::frame::Verdict;
use crate::kernel::camera::{Ray, camera_ray};
use crate::kernel::vector::{cross_product, dot_product, vector_length};
use crate::layout::NO_HIT;
use crate::oracle::Oracle;
use crate::scene::Scene;
use crate::tier::{Accuracy, Double, Extended, Robust};
use crate::watch::Watch;

pub use self::candidates::{CandidateFacts, Interval, MeetingFacts};
pub use self::path::{Path, Step, VolumeKind};

/// How many roundings of f32 make up the whole.
const ROUNDINGS: f64 = 16_777_216.0;

/// One pixel explained.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Why {
    /// Of the picture, in pixels.
    pub width: u32,
    /// Of the picture, in pixels.
    pub height: u32,
    /// The pixel, from the left.
    pub x: u32,
    /// The pixel, from the top.
    pub y: u32,
    /// The bounding volumes in use.
    pub bounds: Bounds,
    /// How many primitives the scene has.
    pub primitives: u32,
    /// The ray.
    pub ray: RayFacts,
    /// The exact answer, of the scene and the ray in f64.
    pub exact: Answer,
    /// What each tier makes of the ray.
    pub tiers: Vec<TierFacts>,
    /// The volumes that hold the shape of the exact answer, or else of the robust tier's.
    pub path: Option<Path>,
    /// Every shape that a tier or the oracle meets or that is in doubt, the nearest first.
    pub candidates: Vec<CandidateFacts>,
}

/// The ray of a pixel.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RayFacts {
    /// Where it starts, relative to the camera: there.
    pub origin: [f64; 3],
    /// Where the camera is in the scene.
    pub eye: [f64; 3],
    /// In f64. t counts in lengths of this.
    pub direction: [f64; 3],
    /// The direction's length.
    pub length: f64,
    /// As the tiers in f32 have it.
    pub direction_f32: [f32; 3],
    /// By how much rounding turns it, in radians.
    pub turned: f64,
}

/// What a ray hits first, exactly.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer {
    /// The shape, if there is one.
    pub id: Option<u32>,
    /// Where.
    pub t: Option<f64>,
    /// By how many roundings of f32 the scene would have to change for another answer.
    pub margin: Option<f64>,
    /// In a sentence.
    pub why: String,
}

/// What a tier makes of a ray.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TierFacts {
    /// The tier.
    pub accuracy: Accuracy,
    /// The shape that it shows, if there is one.
    pub id: Option<u32>,
    /// Where it meets it.
    pub t: Option<f64>,
    /// Whether that is right.
    pub verdict: Verdict,
    /// What would be exact for the numbers that this tier is given.
    pub exact_of_input: Option<u32>,
    /// Whether the first pass was in doubt; only in the adaptive tier.
    pub in_doubt: Option<bool>,
    /// What the ray tested, in the first pass.
    pub counters: Counters,
    /// How the tier came to its answer, in a sentence.
    pub why: String,
}

/// Explains the pixel at (x, y), y downward from the top row.
///
/// # Errors
///
/// [`Error::Usage`] where the picture has no such pixel or the scene is not valid,
/// [`Error::Limit`] where the ray meets too many volumes, [`Error::Interrupted`].
///
/// # Examples
///
/// ```
/// use rayproof::bounds::Bounds;
/// use rayproof::{Scene, Unwatched};
///
/// let scene = Scene::load("assets/scenes/far-sphere.toml")?;
/// let why = rayproof::why::explain(&scene, Bounds::Tree, 128, 128, &Unwatched)?;
/// assert_eq!(why.exact.id, Some(0));
/// # Ok::<(), rayproof::Error>(())
/// ```
pub fn explain(scene: &Scene, bounds: Bounds, x: u32, y: u32, watch: &dyn Watch) -> Result<Why> {
    scene.validate()?;
    let (width, height) = (scene.image.width, scene.image.height);
    if x >= width || y >= height {
        return Err(Error::Usage(format!(
            "pixel {x} {y} is outside of the picture, which is {width} x {height}: \
             x is 0 to {}, y is 0 to {}",
            width - 1,
            height - 1
        )));
    }
    let watched = || match watch.cancelled() {
        true => Err(Error::Interrupted),
        false => Ok(()),
    };
    let (flat, ids) = flatten_with_ids::<f64>(scene);
    let widths = Widths::of(flat, bounds);
    watched()?;

    let single = Truths::of::<Robust>(&widths.robust, x, y);
    let extended = Truths::of::<Extended>(&widths.extended, x, y);
    watched()?;
    let exact = Truths::of::<Double>(&widths.double, x, y);
    let ray = camera_ray(&widths.double.camera, [width, height], x, y);
    let truth = Oracle::new(&widths.double).closest(ray);
    watched()?;

    let first_pass = see(&widths.bounded, x, y)?;
    let seen = Seen {
        textbook: see(&widths.textbook, x, y)?,
        robust: see(&widths.robust, x, y)?,
        extended: see(&widths.extended, x, y)?,
        double: see(&widths.double, x, y)?,
        first_pass,
    };
    let story = Story {
        widths: &widths,
        pixel: [x, y],
        ray,
        seen: &seen,
        single: &single,
        extended: &extended,
        exact: &exact,
    };
    let tier = |accuracy| {
        let (view, truths) = story.decides(accuracy);
        let found = view.found;
        TierFacts {
            accuracy,
            id: shown(found.id),
            t: finite(found.t),
            verdict: verdict(found.id, truth.id),
            exact_of_input: shown(truths.first),
            in_doubt: (accuracy == Accuracy::Adaptive).then_some(seen.first_pass.in_doubt),
            counters: seen.of(accuracy).counters,
            why: story.of_tier(accuracy),
        }
    };
    let robust = Some(seen.robust.found.id).filter(|_| truth.id == NO_HIT);
    Ok(Why {
        width,
        height,
        x,
        y,
        bounds,
        primitives: widths.double.primitives(),
        ray: ray_facts(
            scene,
            ray,
            camera_ray(&widths.robust.camera, [width, height], x, y),
        ),
        exact: Answer {
            id: shown(truth.id),
            t: finite(truth.t),
            margin: finite(truth.margin * ROUNDINGS),
            why: story.of_truth(),
        },
        tiers: Accuracy::ALL.into_iter().map(tier).collect(),
        path: path_to(&widths.robust, robust.unwrap_or(truth.id), x, y),
        candidates: candidates(scene, &ids, &story),
    })
}

fn ray_facts(scene: &Scene, ray: Ray<f64>, rounded: Ray<f32>) -> RayFacts {
    let d = ray.direction;
    let single: [f32; 3] = rounded.direction.into();
    let wide = single.map(f64::from).into();
    RayFacts {
        origin: ray.origin.into(),
        eye: scene.camera.eye.to_array(),
        direction: d.into(),
        length: vector_length(d),
        direction_f32: single,
        turned: vector_length(cross_product(d, wide)).atan2(dot_product(d, wide)),
    }
}

/// An id, unless it stands for no hit.
fn shown(id: u32) -> Option<u32> {
    (id != NO_HIT).then_some(id)
}

/// A number, unless it stands for none.
fn finite(number: f64) -> Option<f64> {
    number.is_finite().then_some(number)
}

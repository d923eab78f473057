//! Rules for how light is added up.

use super::rule::{Verdict, whole};
use crate::scene::Integrator;

/// Paths through a pixel at most.
pub const MAX_SAMPLES: u32 = 65_536;

/// Bounces and reflections of a path at most: of light that surfaces of albedo 0.8 have
/// scattered so often, less than a millionth is left (0.8^64 = 6e-7).
const MAX_EVENTS: u64 = 64;

/// Numbers that a picture can be rendered with.
pub fn integrator(integrator: &Integrator) -> Verdict {
    samples("samples", integrator.samples.into())?;
    events("bounces", integrator.bounces.into())?;
    events("reflections", integrator.reflections.into())
}

/// Paths through a pixel.
pub fn samples(what: &str, n: u64) -> Verdict {
    whole(what, n, 1..=MAX_SAMPLES.into())
}

/// Bounces or reflections of a path.
pub fn events(what: &str, n: u64) -> Verdict {
    whole(what, n, 0..=MAX_EVENTS)
}

/// What random numbers are drawn from.
pub fn seed(what: &str, n: u64) -> Verdict {
    whole(what, n, 0..=u32::MAX.into())
}

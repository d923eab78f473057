//! How a scene is portioned out to a device, and what is measured on the way.

use crate::effects::{EffectSet, Fetch};

/// Primitives that one dispatch tests at most: below the 65,535 loop iterations
/// that lavapipe allows an invocation, with room for the other loops.
const PRIMITIVES_PER_DISPATCH: u32 = 60_000;

/// How a scene is portioned out to a device.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Portions {
    /// Primitives that one dispatch tests at most, where there are no volumes.
    pub primitives_per_dispatch: u32,
    /// Where the scene lies; none for what the device reads best.
    pub fetch: Option<Fetch>,
    /// Effects that are in the shader though the scene may not call for them.
    pub forced: EffectSet,
    /// Whether volumes and shapes are counted, as [`super::render::count`] does.
    pub count: bool,
    /// Whether hits are found and coloured in passes apart, which the device times, see
    /// [`super::render::Prepared::seconds`].
    pub time: bool,
}

/// How long the passes of a picture took, by the device's own clock.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Seconds {
    /// Those in which the closest hits are found.
    pub trace: f64,
    /// Those in which what was hit is coloured.
    pub shade: f64,
}

impl Default for Portions {
    fn default() -> Self {
        Self {
            primitives_per_dispatch: PRIMITIVES_PER_DISPATCH,
            fetch: None,
            forced: EffectSet::NONE,
            count: false,
            time: false,
        }
    }
}

//! Light from infinitely far away.

use super::hard_shadows::shadow_limit;
use super::sources::{Arriving, ENDLESS, nothing_arriving};
use crate::layout::LightRecord;

/// What comes from a directional light.
pub fn arriving_from_direction(lamp: &LightRecord) -> Arriving {
    Arriving {
        towards: lamp.vector.into(),
        color: lamp.color.into(),
        goal: lamp.vector.into(),
        is_far: true,
        limit: shadow_limit(lamp.flags, ENDLESS),
        ..nothing_arriving()
    }
}

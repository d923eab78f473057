//! Lights without size whose light shapes keep off others.

use crate::layout::SHADOW;

/// The part of the way to a light in which something may keep it off; 0 where the light
/// throws no shadows.
pub fn shadow_limit(flags: u32, farthest: f32) -> f32 {
    if flags & SHADOW == 0 { 0.0 } else { farthest }
}

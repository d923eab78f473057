// Lights without size whose light shapes keep off others.

// The part of the way to a light in which something may keep it off; 0 where the light
// throws no shadows.
fn shadow_limit(flags: u32, farthest: f32) -> f32 {
    return select(0.0, farthest, (flags & SHADOW) != 0u);
}

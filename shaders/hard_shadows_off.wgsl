// Lights without size throw no shadows.

fn shadow_limit(flags: u32, farthest: f32) -> f32 {
    return 0.0;
}

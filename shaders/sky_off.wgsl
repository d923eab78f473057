// A background that does not shine.

fn count_skies() -> u32 {
    return 0u;
}

fn arriving_from_sky(path: Path, surface: Surface) -> Arriving {
    return nothing_arriving();
}

fn seen_sky(path: Path) -> vec3<f32> {
    return background_color(vec3<f32>(path.ray.direction));
}

// Clear air.

fn meets_fog(
    path: Path,
    hit: Hit,
    surface: ptr<function, Surface>,
    look: ptr<function, Look>,
) -> bool {
    return false;
}

fn through_fog(color: vec3<f32>, arriving: Arriving) -> vec3<f32> {
    return color;
}

fn cosine_towards(surface: Surface, look: Look, arriving: Arriving) -> f32 {
    return cosine_at_surface(surface, arriving);
}

fn even_cosine(surface: Surface, look: Look, direction: vec3<f32>) -> f32 {
    return dot_product_f32(surface.normal, direction);
}

fn even_direction(surface: Surface, look: Look, pair: vec2<f32>) -> vec3<f32> {
    return cosine_direction(surface.normal, pair);
}

// Direct light alone: a path does not go on where light is scattered evenly.

fn even_chance(path: Path, look: Look) -> f32 {
    return 0.0;
}

fn even_weight(look: Look, arriving: Arriving, cosine: f32) -> f32 {
    return 1.0;
}

fn scatter_evenly(path: ptr<function, Path>, surface: Surface, look: Look) -> bool {
    return false;
}

fn survives(path: ptr<function, Path>) -> bool {
    return true;
}

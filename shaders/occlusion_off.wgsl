// Ambient light comes everywhere.

fn ambient_light(path: ptr<function, Path>, surface: Surface, look: Look) -> vec3<f32> {
    return surroundings.ambient;
}

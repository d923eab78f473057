// Ambient light that what is near keeps off.
//
// Zhukov, Iones, Kronin, "An Ambient Light Illumination Model", EGSR 1998.

// The ambient light at a place, or none where the ray of the sample meets something near.
fn ambient_light(path: ptr<function, Path>, surface: Surface, look: Look) -> vec3<f32> {
    if hidden(sampling.occlusion, surface.position.x) == 0.0 {
        return surroundings.ambient;
    }
    let pair = number_pair((*path).numbers, dimension_of((*path).leg, AMBIENT));
    let direction = even_direction(surface, look, pair);
    let origin = leave_surface(surface.position, surface.facing, direction, surface.reach);
    if is_blocked(path, origin, direction, sampling.occlusion) {
        return vec3<f32>();
    }
    return surroundings.ambient;
}

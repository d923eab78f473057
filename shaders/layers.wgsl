// What is known of a ray's hit besides its colour.

// The layers of a pixel, black.
fn layers_of(path: Path, hit: Hit) -> Pixel {
    let none = vec3<f32>();
    if hit.id == NO_HIT {
        return Pixel(none, 0.0, none, NO_HIT, none, hit.tests);
    }
    let surface = surface_of(path.ray, hit);
    let depth = way_to_hit(path, hit);
    return Pixel(none, depth, surface.normal, hit.id, surface.position, hit.tests);
}

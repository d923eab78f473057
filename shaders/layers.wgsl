// What is known of a ray's hit besides its colour.

// The layers of a pixel, black.
fn layers_of(ray: Ray, hit: Hit) -> Pixel {
    let none = vec3<f32>();
    if hit.id == NO_HIT {
        return Pixel(none, 0.0, none, NO_HIT, none, hit.tests);
    }
    let surface = surface_of(ray, hit);
    let depth = f32(hit.t * vector_length(ray.direction));
    return Pixel(none, depth, surface.normal, hit.id, surface.position, hit.tests);
}

// A matt surface: it scatters light evenly.

// The light that the surface scatters towards the viewer: its albedo times
// the ambient light and the light of every lamp.
fn scattered_light(surface: Surface, albedo: vec3<f32>) -> vec3<f32> {
    let ambient = surroundings.ambient;
    let point = add_point_lights(surface.position, surface.normal, ambient);
    let light = add_directional_lights(surface.normal, point);
    return albedo * light;
}

// A scene without directional lights.

fn add_directional_lights(normal: vec3<f32>, light: vec3<f32>) -> vec3<f32> {
    return light;
}

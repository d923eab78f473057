// A scene without point lights.

fn add_point_lights(position: vec3<f32>, normal: vec3<f32>, light: vec3<f32>) -> vec3<f32> {
    return light;
}

// Light from infinitely far away, by Lambert's cosine law.

@group(1) @binding(2) var<storage, read> directional_lights: array<DirectionalLight>;

// The light that a directional light sends to a unit of surface, without
// occlusion: colour * cos.
fn directional_irradiance(light: DirectionalLight, normal: vec3<f32>) -> vec3<f32> {
    let cosine = dot_product(normal, light.direction);
    if cosine <= 0.0 {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    return light.color * cosine;
}

// `light` and what all directional lights add to it.
fn add_directional_lights(normal: vec3<f32>, light: vec3<f32>) -> vec3<f32> {
    var sum = light;
    for (var i = 0u; i < arrayLength(&directional_lights); i++) {
        sum = sum + directional_irradiance(directional_lights[i], normal);
    }
    return sum;
}

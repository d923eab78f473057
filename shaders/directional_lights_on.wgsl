// Light from infinitely far away, by Lambert's cosine law.

// The light that a directional light sends to a unit of surface, without
// occlusion: colour * cos.
fn directional_irradiance(light: LightRecord, normal: vec3<f32>) -> vec3<f32> {
    let cosine = dot_product_f32(normal, light.vector);
    if cosine <= 0.0 {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    return light.color * cosine;
}

// `light` and what all directional lights add to it.
fn add_directional_lights(normal: vec3<f32>, light: vec3<f32>) -> vec3<f32> {
    let end = hidden_end(tables.light_count, normal.x);
    var sum = light;
    for (var i = surroundings.point_lights; i < end; i++) {
        sum = sum + directional_irradiance(light_at(i), normal);
    }
    return sum;
}

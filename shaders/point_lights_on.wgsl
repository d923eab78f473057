// Light from points, by Lambert's cosine law.

// The light that a point light sends to a unit of surface at `position`,
// without occlusion: colour * cos / distance^2, or colour * cos.
fn point_irradiance(light: LightRecord, position: vec3<f32>, normal: vec3<f32>) -> vec3<f32> {
    let to_light = light.vector - position;
    let square = dot_product_f32(to_light, to_light);
    let along = dot_product_f32(normal, to_light);
    if square == 0.0 || along <= 0.0 {
        return vec3<f32>(0.0, 0.0, 0.0);
    }
    let cosine = divide_f32(along, square_root_f32(square));
    // In a scene that throws no shadows this is the only flag.
    if light.flags == 0u {
        return light.color * cosine;
    }
    return light.color * divide_f32(cosine, square);
}

// `light` and what all point lights add to it.
fn add_point_lights(position: vec3<f32>, normal: vec3<f32>, light: vec3<f32>) -> vec3<f32> {
    let end = hidden_end(surroundings.point_lights, normal.x);
    var sum = light;
    for (var i = 0u; i < end; i++) {
        sum = sum + point_irradiance(light_at(i), position, normal);
    }
    return sum;
}

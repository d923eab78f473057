// What a ray sees that meets nothing.

// A blend of two colours by the height of the ray's unit direction.
fn background_color(direction: vec3<f32>) -> vec3<f32> {
    let height = divide_f32(direction.y, vector_length_f32(direction));
    let weight = surroundings.offset + surroundings.slope * height;
    return surroundings.start * (1.0 - weight) + surroundings.end * weight;
}

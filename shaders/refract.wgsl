// Refraction: Snell's law.

// The unit direction in which light goes on that comes in `direction` upon a surface whose
// unit normal faces it; `ratio` is the index of refraction on this side by that beyond.
// Where none goes through, all is thrown back.
//
// By roundings a cosine may exceed 1, and the square of the other one fall below 0: the
// first counts as 1, the second as a reflection. So no root is taken of a negative number.
fn refracted(direction: vec3<f32>, normal: vec3<f32>, ratio: f32) -> vec3<f32> {
    let unit = unit_vector_f32(tame_vector_f32(direction));
    let along = -dot_product_f32(unit, normal);
    let cosine = select(1.0, along, along < 1.0);
    let across = unit + normal * cosine;
    // The square of the ratio could overflow, and infinity times 0 is no number. And 1 less
    // the square of the cosine would lose a small sine.
    let sine_squared = ratio * (ratio * dot_product_f32(across, across));
    if sine_squared > 1.0 {
        return unit_vector_f32(mirrored(unit, normal));
    }
    let cosine_beyond = square_root_f32(1.0 - sine_squared);
    return unit_vector_f32(tame_vector_f32(across * ratio - normal * cosine_beyond));
}

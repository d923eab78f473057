// A mirror.

// `direction` thrown back by a surface with this unit normal, of either side: as long as it
// was.
fn mirrored(direction: vec3<f32>, normal: vec3<f32>) -> vec3<f32> {
    return direction - normal * (2.0 * dot_product_f32(direction, normal));
}

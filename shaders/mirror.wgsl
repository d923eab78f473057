// A mirror.

// The least cosine at which a surface counts as seen: some roundings of a unit vector.
const LEAST_COSINE: f32 = 1.0 / 1048576.0;

// `direction` thrown back by a surface with this unit normal, of either side: as long as it
// was.
fn mirrored(direction: vec3<f32>, normal: vec3<f32>) -> vec3<f32> {
    return direction - normal * (2.0 * dot_product_f32(direction, normal));
}

// The normal by which a surface mirrors: that of the shape itself where the smooth one is
// turned away from the viewer, in whose direction `view` goes.
fn normal_to_viewer(surface: Surface, view: vec3<f32>) -> vec3<f32> {
    let is_seen = dot_product_f32(surface.normal, view) > LEAST_COSINE;
    return select(surface.facing, surface.normal, is_seen);
}

// The cosine of the angle between such a normal and the viewer: greater than 0, at most 1.
fn cosine_to_viewer(normal: vec3<f32>, view: vec3<f32>) -> f32 {
    let cosine = dot_product_f32(normal, view);
    if cosine < LEAST_COSINE {
        return LEAST_COSINE;
    }
    return select(1.0, cosine, cosine < 1.0);
}

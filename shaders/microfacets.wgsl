// A rough mirror as many small ones, by the distribution of their normals.
//
// Walter, Marschner, Li, Torrance, "Microfacet Models for Refraction through Rough Surfaces",
// EGSR 2007: the distribution of Trowbridge and Reitz (GGX), of a width from 2^-10 to 1. Heitz,
// "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014:
// what of them is seen, and lit. Directions are unit vectors, told by axes of which the third
// is the surface's normal.

// 1 / pi.
const INVERSE_PI: f32 = 0.31830987;

// The root in Smith's masking: that of cos^2 + (width sin)^2.
fn masking_root(cosine: f32, width: f32) -> f32 {
    let square = width * width;
    return square_root_f32(square + (1.0 - square) * (cosine * cosine));
}

// pi times the density of normals in a direction of any length, by projected area and solid
// angle. That the width stands beside the sine, not beside 1 less the square of the cosine, keeps
// narrow lobes from what roundings leave of that.
fn density_of_normals(normal: vec3<f32>, width: f32) -> f32 {
    let square = dot_product_f32(normal, normal);
    let narrow = width * normal.z;
    let spread = (normal.x * normal.x + normal.y * normal.y) + narrow * narrow;
    let part = divide_f32(width * square, spread);
    return part * part;
}

// pi times the density, by solid angle, with which light that goes to `view` is drawn from
// `light`, both above the surface: see `visible_normal`.
fn shape_of_lobe(view: vec3<f32>, light: vec3<f32>, width: f32) -> f32 {
    let normals = density_of_normals(view + light, width);
    return divide_f32(normals, 2.0 * (view.z + masking_root(view.z, width)));
}

// Of the small mirrors that are seen, the part that light from `light` comes to, over the
// cosine of that: G2 / (G1 cos).
fn lit_by_cosine(view: vec3<f32>, light: vec3<f32>, width: f32) -> f32 {
    let seen = masking_root(view.z, width);
    let lit = masking_root(light.z, width);
    return divide_f32(view.z + seen, light.z * seen + view.z * lit);
}

// The normal of one of the small mirrors that are seen from `view`, each as likely as it is
// seen large.
//
// Dupuy, Benyoub, "Sampling Visible GGX Normals with Spherical Caps", Computer Graphics Forum
// 42(8), 2023.
fn visible_normal(view: vec3<f32>, width: f32, pair: vec2<f32>) -> vec3<f32> {
    let stretched = unit_vector_f32(vec3<f32>(view.x * width, view.y * width, view.z));
    // How high the cap is, how high in it the point, and how far that is from both poles.
    let cap = 1.0 + stretched.z;
    let height = pair.y * cap;
    let below = height + (1.0 - stretched.z);
    let above = (1.0 - pair.y) * cap;
    let square = below * above;
    let radius = square_root_f32(select(0.0, square, square > 0.0));
    let point = circle_point(pair.x);
    let normal = vec3<f32>(
        (point.x * radius + stretched.x) * width,
        (point.y * radius + stretched.y) * width,
        height,
    );
    return unit_vector_f32(normal);
}

// Where a ray starts that leaves a surface: far enough not to meet it again.
//
// Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th edition, 6.8.6: by the bound of
// the error, not by a fixed length.

// By how much the start is moved along the normal, in parts of the surface's reach: the
// point is off by at most 12 roundings of it and a test from there by 30, see
// docs/numerics.md.
const OFFSET: f32 = 48.0 / 16777216.0;

// The start of a ray in `direction` from a surface with this unit normal, of a shape that
// reaches so far. In f32 in every width, as rays of a list are.
fn leave_surface(
    position: vec3<f32>,
    facing: vec3<f32>,
    direction: vec3<f32>,
    reach: f32,
) -> vec3<f32> {
    let away = select(facing, -facing, dot_product_f32(facing, direction) < 0.0);
    return position + away * (reach * OFFSET);
}

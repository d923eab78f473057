// Where a ray starts that leaves a surface: far enough not to meet it again.
//
// Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th edition, 6.8.6: by the bound of
// the error, not by a fixed length.

// By how much the start is moved along the normal, in parts of the shape's reach: the point
// is off by at most 10 roundings of it and a test from there by 30, see docs/numerics.md.
const OFFSET: f32 = 48.0 / 16777216.0;

// The start of a ray in `direction` from a point of a surface with this unit normal, of a
// shape that reaches so far from the camera.
fn leave_surface(
    point: vec3<real>,
    normal: vec3<real>,
    direction: vec3<real>,
    reach: real,
) -> vec3<real> {
    let away = select(normal, -normal, dot_product(normal, direction) < 0.0);
    return point + away * (reach * real(OFFSET));
}

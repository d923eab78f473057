// Where a ray starts that leaves a surface, as most textbooks have it: a fixed length away.

// Whatever the scene's scale.
const FIXED_OFFSET: f32 = 1e-3;

fn leave_surface(
    position: vec3<f32>,
    facing: vec3<f32>,
    direction: vec3<f32>,
    reach: f32,
) -> vec3<f32> {
    let away = select(facing, -facing, dot_product_f32(facing, direction) < 0.0);
    return position + away * FIXED_OFFSET;
}

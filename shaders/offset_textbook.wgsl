// Where a ray starts that leaves a surface, as most textbooks have it: a fixed length away.

// Whatever the scene's scale.
const FIXED_OFFSET: f32 = 1e-3;

fn leave_surface(
    point: vec3<real>,
    normal: vec3<real>,
    direction: vec3<real>,
    reach: real,
) -> vec3<real> {
    let away = select(normal, -normal, dot_product(normal, direction) < 0.0);
    return point + away * real(FIXED_OFFSET);
}

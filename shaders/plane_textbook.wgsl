// Infinite plane, as most textbooks have it.

// The slope below which a ray counts as parallel, whatever its length.
const PARALLEL: f32 = 1e-6;

// The t > 0 at which the ray meets the plane through `point`, or MISS.
fn intersect_plane(ray: Ray, point: vec3<real>, normal: vec3<real>) -> real {
    let slope = dot_product(ray.direction, normal);
    if abs(slope) < PARALLEL {
        return MISS;
    }
    let t = divide(dot_product(point - ray.origin, normal), slope);
    if t > 0.0 && t < MISS {
        return t;
    }
    return MISS;
}

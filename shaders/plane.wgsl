// Infinite plane.

// The t > 0 at which the ray meets the plane through `point`, or MISS.
//
// Only d.n = 0 exactly is parallel: t does not depend on the normal's length,
// so any other threshold would be a matter of scale.
fn intersect_plane(ray: Ray, point: vec3<real>, normal: vec3<real>) -> real {
    let slope = dot_product(ray.direction, normal);
    if slope == 0.0 {
        return MISS;
    }
    let t = divide(dot_product(point - ray.origin, normal), slope);
    if t > 0.0 && t < MISS {
        return t;
    }
    return MISS;
}

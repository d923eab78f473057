// Sphere, as most textbooks have it: the baseline, not to be trusted far from its centre.

// The smallest t > 0 at which the ray meets the sphere, or MISS: by b^2 - 4ac.
fn intersect_sphere(ray: Ray, sphere: Sphere) -> real {
    let f = ray.origin - sphere.center;
    let a = dot_product(ray.direction, ray.direction);
    let b = 2.0 * dot_product(f, ray.direction);
    let c = dot_product(f, f) - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return MISS;
    }
    let root = square_root(discriminant);
    let near = divide(-b - root, 2.0 * a);
    if near > 0.0 {
        return near;
    }
    let far = divide(-b + root, 2.0 * a);
    if far > 0.0 {
        return far;
    }
    return MISS;
}

// The outward normal where the ray meets the sphere at `t`.
fn sphere_normal(ray: Ray, sphere: Sphere, t: real) -> vec3<real> {
    let from_center = (ray.origin + ray.direction * t) - sphere.center;
    return from_center * divide(1.0, sphere.radius);
}

// The point of the sphere that is met at `t`, under the outward normal.
fn sphere_point(ray: Ray, sphere: Sphere, normal: vec3<real>, t: real) -> vec3<real> {
    return sphere.center + normal * sphere.radius;
}

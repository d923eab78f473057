// No sphere has the camera near its surface.

fn is_near(sphere: Sphere) -> bool {
    return false;
}

fn starts_near(sphere: Sphere, power: real) -> bool {
    return false;
}

fn sphere_power(origin: vec3<real>, sphere: Sphere) -> real {
    let f = origin - sphere.center;
    return dot_product(f, f) - sphere.radius * sphere.radius;
}

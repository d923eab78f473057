// Spheres near whose surface the camera is, such as a planet under it.
//
// The power of a point is |p - c|^2 - r^2. There, two large squares almost cancel, and
// with them what f32 knows of the height above the surface. So the host computes the
// camera's own power before it rounds; from a point elsewhere, what is to be added has
// the size of the way there.

// In place of the power of a sphere that the camera is not near.
const FAR: f32 = 3.4028234663852886e38;

// Whether the camera's power is known.
fn is_near(sphere: Sphere) -> bool {
    return sphere.power < real(FAR);
}

// Whether a ray whose origin has this power starts near such a sphere too. From afar its
// discriminant is that of any sphere: made of powers, it would cancel.
fn starts_near(sphere: Sphere, power: real) -> bool {
    return is_near(sphere) && abs(power) < sphere.radius * sphere.radius;
}

// The power of a ray's origin.
fn sphere_power(origin: vec3<real>, sphere: Sphere) -> real {
    if is_near(sphere) {
        let way = dot_product(origin, origin) - 2.0 * dot_product(origin, sphere.center);
        return way + sphere.power;
    }
    let f = origin - sphere.center;
    return dot_product(f, f) - sphere.radius * sphere.radius;
}

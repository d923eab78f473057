// Sphere: Haines, Günther, Akenine-Möller, "Precision Improvements for
// Ray/Sphere Intersection", Ray Tracing Gems (2019), chapter 7.

// The smallest t > 0 at which the ray meets the sphere, or MISS.
//
// The discriminant is taken at the ray's point nearest to the centre, where
// nothing large cancels, and the small root comes from the large one. Near the surface
// of a large sphere, see near_spheres_on.wgsl.
fn intersect_sphere(ray: Ray, sphere: Sphere) -> real {
    let f = ray.origin - sphere.center;
    let d = ray.direction;
    let a = dot_product(d, d);
    let b = -dot_product(f, d);
    let c = sphere_power(ray.origin, sphere);
    let l = f + d * divide(b, a);
    var discriminant = sphere.radius * sphere.radius - dot_product(l, l);
    if is_near(sphere) && c < sphere.radius * sphere.radius {
        discriminant = divide(b * b - a * c, a);
    }
    if discriminant < 0.0 {
        return MISS;
    }
    let q = b + copy_sign(square_root(a * discriminant), b);
    if q == 0.0 {
        return MISS;
    }
    let t0 = divide(c, q);
    let t1 = divide(q, a);
    let near = select(t1, t0, t0 < t1);
    let far = select(t0, t1, t0 < t1);
    if near > 0.0 {
        return near;
    }
    if far > 0.0 {
        return far;
    }
    return MISS;
}

// The outward unit normal where the ray meets the sphere at `t`.
//
// Measured from the centre along l, not as origin + t * direction: the error
// is then relative to the radius, not to the distance.
fn sphere_normal(ray: Ray, sphere: Sphere, t: real) -> vec3<real> {
    let f = ray.origin - sphere.center;
    let d = ray.direction;
    let a = dot_product(d, d);
    let middle = divide(-dot_product(f, d), a);
    let l = f + d * middle;
    let discriminant = sphere.radius * sphere.radius - dot_product(l, l);
    let half_chord = square_root(divide(discriminant, a));
    return unit_vector(l + d * copy_sign(half_chord, t - middle));
}

// The point of the sphere that is met at `t`, under the outward unit normal.
fn sphere_point(ray: Ray, sphere: Sphere, normal: vec3<real>, t: real) -> vec3<real> {
    if is_near(sphere) {
        return ray.origin + ray.direction * t;
    }
    return sphere.center + normal * sphere.radius;
}

// Triangle, as most textbooks have it: Möller, Trumbore, "Fast, Minimum Storage Ray/Triangle
// Intersection", Journal of Graphics Tools 2(1), 1997, with its absolute epsilon.

// The determinant below which a triangle counts as seen edge-on, whatever its size.
const EDGE_ON: f32 = 1e-6;

// This formula needs nothing that is common to all triangles.
struct Shear {
    unused: u32,
}

// Where the ray meets the triangle's plane.
struct Crossing {
    // The ray's parameter, or MISS.
    t: real,
    // Weight of the second corner.
    u: real,
    // Weight of the third corner.
    v: real,
}

fn shear_of(ray: Ray) -> Shear {
    return Shear(0u);
}

// Where the ray crosses the triangle.
fn cross_triangle(ray: Ray, triangle: Triangle) -> Crossing {
    let edge_b = triangle.b - triangle.a;
    let edge_c = triangle.c - triangle.a;
    let across = cross_product(ray.direction, edge_c);
    let determinant = dot_product(edge_b, across);
    if abs(determinant) < EDGE_ON {
        return Crossing(MISS, 0.0, 0.0);
    }
    let inverse = divide(1.0, determinant);
    let from_a = ray.origin - triangle.a;
    let u = dot_product(from_a, across) * inverse;
    let along = cross_product(from_a, edge_b);
    let v = dot_product(ray.direction, along) * inverse;
    if u < 0.0 || v < 0.0 || u + v > 1.0 {
        return Crossing(MISS, 0.0, 0.0);
    }
    let t = dot_product(edge_c, along) * inverse;
    if t > 0.0 && t < MISS {
        return Crossing(t, u, v);
    }
    return Crossing(MISS, 0.0, 0.0);
}

// The t > 0 at which the ray meets the triangle, or MISS.
fn intersect_triangle(ray: Ray, shear: Shear, triangle: Triangle) -> real {
    return cross_triangle(ray, triangle).t;
}

// The weights of the three corners where the ray meets the triangle.
fn triangle_weights(ray: Ray, triangle: Triangle) -> vec3<real> {
    let crossing = cross_triangle(ray, triangle);
    let a = (1.0 - crossing.u) - crossing.v;
    return vec3<real>(a, crossing.u, crossing.v);
}

// The point of the triangle with these weights.
fn triangle_point(triangle: Triangle, weights: vec3<real>) -> vec3<real> {
    return (triangle.a * weights.x + triangle.b * weights.y) + triangle.c * weights.z;
}

// The unit normal, towards who sees the corners counter-clockwise.
fn triangle_normal(triangle: Triangle) -> vec3<real> {
    return unit_vector(cross_product(triangle.b - triangle.a, triangle.c - triangle.a));
}

// Triangle: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection",
// JCGT 2(1), 2013.

// What the test needs of a ray, computed once for all triangles: the space in
// which the ray runs along the last axis.
struct Shear {
    // The axis along which the direction is largest: 0, 1 or 2.
    axis: u32,
    // Shift in the first and second other axis for a unit step along `axis`.
    x: real,
    y: real,
    // The direction's component along `axis`.
    z: real,
}

// The edge functions: the corners' weights times their sum, the `determinant`.
struct Edges {
    u: real,
    v: real,
    w: real,
    // u + v + w; zero where the ray misses.
    determinant: real,
    // The corners' positions along the shear's axis.
    along: vec3<real>,
}

// v with its components turned so that `axis` comes last.
fn axis_last(v: vec3<real>, axis: u32) -> vec3<real> {
    return select(select(v, v.zxy, axis == 1u), v.yzx, axis == 0u);
}

// The ray's shear.
fn shear_of(ray: Ray) -> Shear {
    let size = abs(ray.direction);
    let xy = select(1u, 0u, size.x > size.y);
    let largest = select(size.y, size.x, size.x > size.y);
    let axis = select(2u, xy, largest > size.z);
    let d = axis_last(ray.direction, axis);
    return Shear(axis, divide(d.x, d.z), divide(d.y, d.z), d.z);
}

// The edge functions of a triangle as the ray sees it. A triangle whose edge
// functions differ in sign is missed.
//
// An edge is left or right of the ray as one rounded product compares with the
// other. Two triangles that share an edge compare the same two products, so no
// ray slips between them, even where a compiler contracts their difference.
fn edge_functions(ray: Ray, shear: Shear, triangle: Triangle) -> Edges {
    let a = axis_last(triangle.a - ray.origin, shear.axis);
    let b = axis_last(triangle.b - ray.origin, shear.axis);
    let c = axis_last(triangle.c - ray.origin, shear.axis);
    let ax = a.x - shear.x * a.z;
    let ay = a.y - shear.y * a.z;
    let bx = b.x - shear.x * b.z;
    let by = b.y - shear.y * b.z;
    let cx = c.x - shear.x * c.z;
    let cy = c.y - shear.y * c.z;

    let u_left = cx * by;
    let u_right = cy * bx;
    let v_left = ax * cy;
    let v_right = ay * cx;
    let w_left = bx * ay;
    let w_right = by * ax;
    let none_negative = u_left >= u_right && v_left >= v_right && w_left >= w_right;
    let none_positive = u_left <= u_right && v_left <= v_right && w_left <= w_right;
    if !(none_negative || none_positive) {
        return Edges();
    }
    let u = u_left - u_right;
    let v = v_left - v_right;
    let w = w_left - w_right;
    return Edges(u, v, w, (u + v) + w, vec3<real>(a.z, b.z, c.z));
}

// The edge functions over their sum. Dividing before the distance is formed
// keeps products of three lengths, which overflow, from arising.
fn corner_weights(edges: Edges) -> vec3<real> {
    return vec3<real>(
        divide(edges.u, edges.determinant),
        divide(edges.v, edges.determinant),
        divide(edges.w, edges.determinant),
    );
}

// The t > 0 at which the ray meets the triangle, from either side, its edges
// included, or MISS.
fn intersect_triangle(ray: Ray, shear: Shear, triangle: Triangle) -> real {
    let edges = edge_functions(ray, shear, triangle);
    if edges.determinant == 0.0 {
        return MISS;
    }
    let t = divide(dot_product(corner_weights(edges), edges.along), shear.z);
    if t > 0.0 && t < MISS {
        return t;
    }
    return MISS;
}

// The weights of the three corners where the ray meets the triangle.
fn triangle_weights(ray: Ray, triangle: Triangle) -> vec3<real> {
    return corner_weights(edge_functions(ray, shear_of(ray), triangle));
}

// The point of the triangle with these weights.
fn triangle_point(triangle: Triangle, weights: vec3<real>) -> vec3<real> {
    return (triangle.a * weights.x + triangle.b * weights.y) + triangle.c * weights.z;
}

// The unit normal, towards who sees the corners counter-clockwise. The cross
// product is a square of lengths, and its length takes the square of that. Measured from the
// last corner: with the first two exchanged, it is the opposite in every bit.
fn triangle_normal(triangle: Triangle) -> vec3<real> {
    let across = cross_product(triangle.a - triangle.c, triangle.b - triangle.c);
    return unit_vector(tame_vector(across));
}

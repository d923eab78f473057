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

// The corners as the ray sees them, which runs along the last axis: a number of each.
struct Seen {
    // To the right of the ray.
    x: vec3<real>,
    // Above the ray.
    y: vec3<real>,
    // Along the shear's axis.
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

// The corners of a triangle as the ray sees them.
fn seen_corners(ray: Ray, shear: Shear, triangle: Triangle) -> Seen {
    let a = axis_last(triangle.a - ray.origin, shear.axis);
    let b = axis_last(triangle.b - ray.origin, shear.axis);
    let c = axis_last(triangle.c - ray.origin, shear.axis);
    return Seen(
        vec3<real>(
            a.x - shear.x * a.z,
            b.x - shear.x * b.z,
            c.x - shear.x * c.z,
        ),
        vec3<real>(
            a.y - shear.y * a.z,
            b.y - shear.y * b.z,
            c.y - shear.y * c.z,
        ),
        vec3<real>(a.z, b.z, c.z),
    );
}

// Whether the ray passes between the corners: left of no edge or right of none. On all
// three it is where the triangle is a line, which is missed.
//
// An edge is left or right of the ray as one rounded product compares with the
// other. Two triangles that share an edge compare the same two products, so no
// ray slips between them, even where a compiler contracts their difference.
fn passes_between(seen: Seen) -> bool {
    let u_left = seen.x.z * seen.y.y;
    let u_right = seen.y.z * seen.x.y;
    let v_left = seen.x.x * seen.y.z;
    let v_right = seen.y.x * seen.x.z;
    let w_left = seen.x.y * seen.y.x;
    let w_right = seen.y.y * seen.x.x;
    let none_negative = u_left >= u_right && v_left >= v_right && w_left >= w_right;
    let none_positive = u_left <= u_right && v_left <= v_right && w_left <= w_right;
    return none_negative != none_positive;
}

// The corner that the vertical through the ray parts from the two others: 0, 1 or 2. Corners
// on the vertical go to the left, unless that leaves none to the right; so do those that are
// right of it by less than a normal number.
fn lone_corner(x: vec3<real>) -> u32 {
    let xy = select(x.y, x.x, x.x > x.y);
    let rightmost = select(x.z, xy, xy > x.z);
    let least: real = 1.1754943508222875e-38;
    let limit = select(least, rightmost, rightmost < least);
    let a = x.x >= limit;
    let b = x.y >= limit;
    let c = x.z >= limit;
    return select(select(0u, 1u, a == c), 2u, a == b);
}

// A number of each corner, that of one exchanged with the last.
fn exchanged(v: vec3<real>, corner: u32) -> vec3<real> {
    let x = select(v.x, v.z, corner == 0u);
    let y = select(v.y, v.z, corner == 1u);
    return vec3<real>(x, y, select(select(v.z, v.y, corner == 1u), v.x, corner == 0u));
}

// The corners, one exchanged with the last.
fn with_last(seen: Seen, corner: u32) -> Seen {
    return Seen(
        exchanged(seen.x, corner),
        exchanged(seen.y, corner),
        exchanged(seen.along, corner),
    );
}

// The weights of the corners, the lone one last, where the ray is. The vertical cuts the two
// edges from the lone corner, and the ray is between the cuts. As what is divided has no
// cancelled digits, the weights give a point that is some roundings of the triangle's extent
// off the ray, whatever its shape.
fn weights_between(seen: Seen) -> vec3<real> {
    let aside = abs(seen.x.z);
    let first = divide(aside, aside + abs(seen.x.x));
    let second = divide(aside, aside + abs(seen.x.y));
    let first_y = abs(seen.y.z + first * (seen.y.x - seen.y.z));
    let second_y = abs(seen.y.z + second * (seen.y.y - seen.y.z));
    let apart = first_y + second_y;
    var of_first: real = 0.5;
    var of_second: real = 0.5;
    if apart > 0.0 {
        of_first = divide(second_y, apart);
        of_second = divide(first_y, apart);
    }
    let x = of_first * first;
    let y = of_second * second;
    return vec3<real>(x, y, 1.0 - (x + y));
}

// How far along the shear's axis the ray meets the triangle, if it passes between the corners:
// exactly, where all three are as far.
fn depth_between(seen: Seen) -> real {
    let lone_last = with_last(seen, lone_corner(seen.x));
    let weights = weights_between(lone_last);
    let along = lone_last.along;
    return along.z + (weights.x * (along.x - along.z) + weights.y * (along.y - along.z));
}

// The t > 0 at which the ray meets the triangle, from either side, its edges
// included, or MISS.
fn intersect_triangle(ray: Ray, shear: Shear, triangle: Triangle) -> real {
    let seen = seen_corners(ray, shear, triangle);
    if !passes_between(seen) {
        return MISS;
    }
    let t = divide(depth_between(seen), shear.z);
    if t > 0.0 && t < MISS {
        return t;
    }
    return MISS;
}

// The weights of the three corners where the ray meets the triangle.
fn triangle_weights(ray: Ray, triangle: Triangle) -> vec3<real> {
    let seen = seen_corners(ray, shear_of(ray), triangle);
    let lone = lone_corner(seen.x);
    return exchanged(weights_between(with_last(seen, lone)), lone);
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

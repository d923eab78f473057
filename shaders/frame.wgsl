// Axes about a direction, and directions told by them.

// Three unit vectors, each at right angles to the others; right-handed.
struct Axes {
    // The first axis.
    right: vec3<f32>,
    // The second.
    up: vec3<f32>,
    // The third: the direction about which they are.
    along: vec3<f32>,
}

// Axes about a unit normal, as near to unit length and to right angles as it is to unit
// length, and 2^-21 besides.
//
// Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin, "Building an Orthonormal
// Basis, Revisited", JCGT 6(1), 2017.
fn axes_around(normal: vec3<f32>) -> Axes {
    let sign = select(-1.0, 1.0, normal.z >= 0.0);
    let a = divide_f32(-1.0, sign + normal.z);
    let b = (normal.x * normal.y) * a;
    return Axes(
        vec3<f32>(
            1.0 + sign * ((normal.x * normal.x) * a),
            sign * b,
            -(sign * normal.x),
        ),
        vec3<f32>(b, sign + (normal.y * normal.y) * a, -normal.y),
        normal,
    );
}

// The vector that goes so far along each of the axes.
fn from_axes(axes: Axes, x: f32, y: f32, z: f32) -> vec3<f32> {
    return (axes.right * x + axes.up * y) + axes.along * z;
}

// How far `v` goes along each of the axes.
fn to_axes(axes: Axes, v: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(
        dot_product_f32(axes.right, v),
        dot_product_f32(axes.up, v),
        dot_product_f32(axes.along, v),
    );
}

// The unit direction on the normal's side for a point of the unit square: as many near a
// direction as its cosine to the normal says. At the square's edge the cosine is 0, give or
// take a rounding.
//
// Malley's method: a point of the disk, lifted to the half sphere above it.
fn cosine_direction(normal: vec3<f32>, pair: vec2<f32>) -> vec3<f32> {
    let point = disk_point(pair);
    let rest = 1.0 - (point.x * point.x + point.y * point.y);
    // By roundings a point may be outside the circle.
    let height = square_root_f32(select(0.0, rest, rest > 0.0));
    return from_axes(axes_around(normal), point.x, point.y, height);
}

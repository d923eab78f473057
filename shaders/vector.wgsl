// Vectors of three, with the order of every sum written out. WGSL's own dot,
// length and normalize leave the order and the rounding to the driver.

// a . b, summed from x to z.
fn dot_product(a: vec3<real>, b: vec3<real>) -> real {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

// a x b.
fn cross_product(a: vec3<real>, b: vec3<real>) -> vec3<real> {
    return vec3<real>(
        a.y * b.z - a.z * b.y,
        a.z * b.x - a.x * b.z,
        a.x * b.y - a.y * b.x,
    );
}

// |v|.
fn vector_length(v: vec3<real>) -> real {
    return square_root(dot_product(v, v));
}

// v / |v|, one division a component; the zero vector stays zero.
fn unit_vector(v: vec3<real>) -> vec3<real> {
    let length = vector_length(v);
    if length == 0.0 {
        return v;
    }
    return vec3<real>(divide(v.x, length), divide(v.y, length), divide(v.z, length));
}

// v over its largest component, so that its square neither overflows nor
// vanishes; the zero vector stays zero.
fn tame_vector(v: vec3<real>) -> vec3<real> {
    let size = abs(v);
    let xy = select(size.y, size.x, size.x > size.y);
    let largest = select(size.z, xy, xy > size.z);
    if largest == 0.0 {
        return v;
    }
    return vec3<real>(divide(v.x, largest), divide(v.y, largest), divide(v.z, largest));
}

// |v.x| + |v.y| + |v.z|: from |v| to 1.74 |v|, without a root.
fn taxicab_length(v: vec3<real>) -> real {
    return (abs(v.x) + abs(v.y)) + abs(v.z);
}

// n, or -n where n points along `direction`, so that it faces who looks.
fn face_viewer(n: vec3<real>, direction: vec3<real>) -> vec3<real> {
    if dot_product(n, direction) > 0.0 {
        return -n;
    }
    return n;
}

// v / by, one division a component.
fn divided(v: vec3<real>, by: real) -> vec3<real> {
    return vec3<real>(divide(v.x, by), divide(v.y, by), divide(v.z, by));
}

// The largest component of v.
fn largest_coordinate(v: vec3<real>) -> real {
    let xy = select(v.y, v.x, v.x > v.y);
    return select(v.z, xy, xy > v.z);
}

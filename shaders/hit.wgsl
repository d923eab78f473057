// The closest hit so far, and the surface that is found there.

const NO_HIT: u32 = 0xffffffffu;

// In place of a hit's tests: the ray was given up.
const GIVEN_UP: u32 = 0xffffffffu;

// In place of a ray's tile: it is none of the rays that go through one of a tile's pixels.
const NO_TILE: u32 = 0xffffffffu;

// The closest hit so far.
struct Hit {
    // The ray's parameter there, or MISS.
    t: real,
    // The primitive, or NO_HIT.
    id: u32,
    // Its row in its kind's table.
    row: u32,
    // The ray's parameter lies between this and `high`, where formulas bound their error.
    low: real,
    // See `low`; MISS where nothing is hit for certain.
    high: real,
    // The least parameter at which the ray may meet another primitive.
    rival: real,
    // Shapes tested so far.
    tests: u32,
    // The tile of the screen that the ray goes through.
    tile: u32,
    // How far the ray has come in the list of volumes: the entry, and the primitives
    // of a run that are done.
    entry: u32,
    done: u32,
    // Volumes tested so far, and those of them that the ray met.
    bound_tests: u32,
    bound_hits: u32,
}

// Where a ray meets a primitive first.
struct Meeting {
    // The ray's parameter there, or MISS.
    t: real,
    // No sooner than here; MISS where it certainly does not.
    low: real,
    // No later than here; MISS where it may not meet it at all.
    high: real,
}

// What shading needs to know of a hit, and a ray that leaves from there.
struct Surface {
    // Camera-relative.
    position: vec3<f32>,
    // Unit length, facing the viewer.
    normal: vec3<f32>,
    // The same of the shape itself: another one where normals are smooth.
    facing: vec3<f32>,
    // How far the shape reaches from the camera, and the ray's origin, by their taxicab
    // lengths: what roundings are parts of.
    reach: f32,
}

// Nothing hit, nothing tested.
fn no_hit() -> Hit {
    return Hit(MISS, NO_HIT, 0u, MISS, MISS, MISS, 0u, 0u, 0u, 0u, 0u, 0u);
}

// Counts a shape that was tested.
fn count_test(hit: ptr<function, Hit>) {
    (*hit).tests += 1u;
}

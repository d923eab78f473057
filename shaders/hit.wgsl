// The closest hit so far, and the surface that is found there.

const NO_HIT: u32 = 0xffffffffu;

// The closest hit so far.
struct Hit {
    // The ray's parameter there, or MISS.
    t: real,
    // The primitive, or NO_HIT.
    id: u32,
    // Shapes tested so far.
    tests: u32,
}

// What shading needs to know of a hit.
struct Surface {
    // Camera-relative.
    position: vec3<f32>,
    // Unit length, facing the viewer.
    normal: vec3<f32>,
}

// Nothing hit, nothing tested.
fn no_hit() -> Hit {
    return Hit(MISS, NO_HIT, 0u);
}

// Counts a test and keeps its hit if it is nearer. Of two hits at the same t the
// lower id stays, so the order of the tests does not matter.
fn keep_nearer(hit: ptr<function, Hit>, t: real, id: u32) {
    (*hit).tests += 1u;
    if t < (*hit).t || (t == (*hit).t && id < (*hit).id && t < MISS) {
        (*hit).t = t;
        (*hit).id = id;
    }
}

// A ray with all that its tests share, computed once.

// A ray with all that its tests share: for boxes, for triangles.
struct Probe {
    ray: Ray,
    slabs: Slabs,
    shear: Shear,
}

// Prepares a ray.
fn probe_of(ray: Ray) -> Probe {
    return Probe(ray, slabs_of(ray), shear_of(ray));
}

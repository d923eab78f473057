// Any rays, in a list, and what they find.

// Of each ray, where it starts and where it goes; in f32 in every width.
@group(0) @binding(12) var<storage, read> rays: array<vec4<f32>>;

// Of each leg of a ray, the parts of t and the primitive; t is below 0 where the ray was
// given up.
@group(0) @binding(13) var<storage, read_write> found: array<vec4<u32>>;

// Ray `index` of the list.
fn ray_at(index: u32) -> Ray {
    let origin = rays[2u * index].xyz;
    let direction = rays[2u * index + 1u].xyz;
    return Ray(vec3<real>(origin), vec3<real>(direction));
}

// Leaves what was found.
fn keep_found(place: u32, hit: Hit) {
    var parts = parts_of(hit.t);
    if hit.tests == GIVEN_UP {
        parts.x = -1.0;
    }
    found[place] = vec4<u32>(bitcast<vec3<u32>>(parts), hit.id);
}

// Rays that go on where they meet something: paths, of so many legs each.

// Of each ray, where its path goes on from a surface: a vector, and its kind.
@group(0) @binding(14) var<storage, read> aims: array<vec4<f32>>;

// Of each path, the ray after its last leg, as in `rays`.
@group(0) @binding(15) var<storage, read_write> ends: array<vec4<f32>>;

// The aim of ray `index`.
fn aim_at(index: u32) -> AimRecord {
    let aim = aims[index];
    return AimRecord(aim.xyz, aim.w);
}

// Follows a path to its last leg, or to one that is in doubt or given up; tells of that.
fn trace_ray(index: u32) -> Hit {
    let first = dispatch.legs * index;
    let aim = aim_at(index);
    var ray = ray_at(index);
    var hit = no_hit();
    // What is left of it if a driver stops the loop.
    hit.tests = GIVEN_UP;
    keep_found(first + dispatch.legs - 1u, hit);
    let end = hidden_end(dispatch.legs, aim.kind);
    for (var leg = 0u; leg < end; leg++) {
        hit = no_hit();
        if !is_over(ray) {
            closest_hit(probe_of(ray), &hit);
        }
        keep_found(first + leg, hit);
        if hit.tests == GIVEN_UP || is_in_doubt(hit) {
            break;
        }
        ray = next_ray(ray, hit, aim);
    }
    ends[2u * index] = vec4<f32>(vec3<f32>(ray.origin), 0.0);
    ends[2u * index + 1u] = vec4<f32>(vec3<f32>(ray.direction), 0.0);
    return hit;
}

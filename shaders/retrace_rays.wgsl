// The rays of a list that are in doubt, one invocation each.

// How many there are, then which, as the first pass left them.
@group(0) @binding(10) var<storage, read_write> doubtful: array<u32>;

// Finds the closest hit of each anew.
@compute @workgroup_size(64)
fn retrace(@builtin(global_invocation_id) at: vec3<u32>) {
    if at.x < doubtful[0] {
        _ = trace_ray(doubtful[1u + at.x]);
    }
}

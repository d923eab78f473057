// All rays of a list, one invocation each.

// Finds the closest hit of each.
@compute @workgroup_size(64)
fn trace_rays(@builtin(global_invocation_id) at: vec3<u32>) {
    if at.x < dispatch.rows {
        list_doubtful(at.x, trace_ray(at.x));
    }
}

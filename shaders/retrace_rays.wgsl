// The rays of a list that are in doubt, one invocation each.

// How many there are, then which, as the first pass left them.
@group(0) @binding(10) var<storage, read_write> doubtful: array<u32>;

// Finds the closest hit of the ray at a place of the dispatch's portion of the list anew.
fn retrace_ray(of_portion: u32) {
    let place = dispatch.first_doubtful + of_portion;
    if place < doubtful[0] {
        _ = trace_ray(doubtful[1u + place]);
    }
}

// A long list.
@compute @workgroup_size(64)
fn retrace(@builtin(global_invocation_id) at: vec3<u32>) {
    retrace_ray(at.x);
}

// A short list, see retrace.wgsl.
@compute @workgroup_size(8)
fn retrace_few(
    @builtin(workgroup_id) workgroup: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    retrace_ray(8u * (workgroup.z * workgroups.x + workgroup.x) + lane);
}

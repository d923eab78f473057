// Rays in doubt, from a list, one invocation each.

// How many there are, then which, as the first pass left them.
@group(0) @binding(10) var<storage, read_write> doubtful: array<u32>;

// Traces the ray at a place of the dispatch's portion of the list anew.
fn retrace_at(of_portion: u32) {
    let place = dispatch.first_doubtful + of_portion;
    if place < doubtful[0] {
        trace_anew(doubtful[1u + place]);
    }
}

// A long list.
@compute @workgroup_size(64)
fn retrace(@builtin(global_invocation_id) at: vec3<u32>) {
    retrace_at(at.x);
}

// A short list, dealt out in slices to as many threads as there are: its rays have little in
// common that would pay for keeping them together.
@compute @workgroup_size(8)
fn retrace_few(
    @builtin(workgroup_id) workgroup: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    retrace_at(8u * (workgroup.z * workgroups.x + workgroup.x) + lane);
}

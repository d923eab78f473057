// The rays of a list that are in doubt.

// Finds the closest hit of a ray of the list anew.
fn trace_anew(index: u32) {
    _ = trace_ray(index);
}

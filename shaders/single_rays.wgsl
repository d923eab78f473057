// Rays that end where they meet something.

// Finds the closest hit of a ray of the list.
fn trace_ray(index: u32) -> Hit {
    var hit = no_hit();
    closest_hit(probe_of(ray_at(index)), &hit);
    keep_found(index, hit);
    return hit;
}

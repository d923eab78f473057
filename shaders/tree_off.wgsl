// No volumes: every primitive is tested.

// The nearest of all primitives of the dispatch.
fn closest_hit(probe: Probe, hit: ptr<function, Hit>) {
    closest_sphere(probe, hit);
    closest_plane(probe, hit);
    closest_disk(probe, hit);
    closest_triangle(probe, hit);
}

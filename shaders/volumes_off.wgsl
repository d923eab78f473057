// No volumes: every primitive of the dispatch is tested.

fn closest_in_volumes(probe: Probe, hit: ptr<function, Hit>) {
    closest_sphere(probe, hit);
    closest_plane(probe, hit);
    closest_disk(probe, hit);
    closest_triangle(probe, hit);
}

fn load_cursor(index: u32, hit: ptr<function, Hit>) {
}

fn store_cursor(index: u32, hit: Hit) {
}

// No volumes: every primitive of the dispatch is tested.

fn closest_in_volumes(probe: Probe, hit: ptr<function, Hit>) {
    test_spheres(probe, dispatch.spheres.begin, hidden_end(dispatch.spheres.end), hit);
    closest_plane(probe, hit);
    test_disks(probe, dispatch.disks.begin, hidden_end(dispatch.disks.end), hit);
    test_triangles(probe, dispatch.triangles.begin, hidden_end(dispatch.triangles.end), hit);
}

fn load_cursor(index: u32, hit: ptr<function, Hit>) {
}

fn store_cursor(index: u32, hit: Hit) {
}

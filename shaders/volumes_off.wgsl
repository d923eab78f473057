// No volumes: every primitive of the dispatch is tested.

fn closest_in_volumes(probe: Probe, hit: ptr<function, Hit>) {
    let number = probe.slabs.inverse.x;
    test_spheres(probe, dispatch.spheres.begin, hidden_end(dispatch.spheres.end, number), hit);
    closest_plane(probe, hit);
    test_disks(probe, dispatch.disks.begin, hidden_end(dispatch.disks.end, number), hit);
    test_triangles(probe, dispatch.triangles.begin, hidden_end(dispatch.triangles.end, number), hit);
}

fn load_cursor(index: u32, hit: ptr<function, Hit>) {
}

fn store_cursor(index: u32, hit: Hit) {
}

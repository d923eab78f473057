// No tree: volumes in a list, or none.

fn closest_hit(probe: Probe, hit: ptr<function, Hit>) {
    closest_in_volumes(probe, hit);
}

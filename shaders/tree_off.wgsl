// No tree: volumes in a list, or none.

fn closest_hit(probe: Probe, hit: ptr<function, Hit>) {
    closest_in_volumes(probe, hit);
}

// Whether anything is met no later than at `limit`.
fn any_hit(probe: Probe, limit: real, hit: ptr<function, Hit>) -> bool {
    (*hit).t = limit;
    closest_in_volumes(probe, hit);
    return (*hit).id != NO_HIT;
}

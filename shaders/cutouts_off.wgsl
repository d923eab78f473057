// Shapes without holes.

// What the path's ray meets first.
fn seen_hit(path: ptr<function, Path>) -> Hit {
    var hit = no_hit();
    hit.tile = NO_TILE;
    closest_hit(probe_of((*path).ray), &hit);
    (*path).is_lost |= hit.tests == GIVEN_UP;
    return hit;
}

// Whether a ray meets anything no later than at `limit`, in lengths of its direction.
fn is_blocked(
    path: ptr<function, Path>,
    origin: vec3<f32>,
    direction: vec3<f32>,
    limit: f32,
) -> bool {
    var hit = no_hit();
    hit.tile = NO_TILE;
    let ray = Ray(vec3<real>(origin), vec3<real>(direction));
    let blocked = any_hit(probe_of(ray), real(limit), &hit);
    (*path).is_lost |= hit.tests == GIVEN_UP;
    return blocked;
}

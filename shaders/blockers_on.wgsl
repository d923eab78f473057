// Shapes that keep light off others.

// Whether something lies between a place and the source that light comes from.
fn is_shadowed(path: ptr<function, Path>, surface: Surface, arriving: Arriving) -> bool {
    if arriving.limit == 0.0 {
        return false;
    }
    let towards = arriving.towards;
    let origin = leave_surface(surface.position, surface.facing, towards, surface.reach);
    let direction = select(arriving.goal - origin, arriving.goal, arriving.is_far);
    return is_blocked(path, origin, direction, arriving.limit);
}

// Shapes that keep light off others.

// Whether something lies between a place and the source that light comes from.
fn is_shadowed(path: ptr<function, Path>, surface: Surface, arriving: Arriving) -> bool {
    if arriving.limit == 0.0 {
        return false;
    }
    let towards = arriving.towards;
    // What a smooth normal sees, but for the surface itself: no path goes there either.
    if dot_product_f32(surface.facing, towards) < 0.0 {
        return true;
    }
    let origin = leave_surface(surface.position, surface.facing, towards, surface.reach);
    let direction = select(arriving.goal - origin, arriving.goal, arriving.is_far);
    return is_blocked(path, origin, direction, arriving.limit);
}

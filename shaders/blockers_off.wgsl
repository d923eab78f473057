// Nothing keeps light off anything.

fn is_shadowed(path: ptr<function, Path>, surface: Surface, arriving: Arriving) -> bool {
    return false;
}

// No clear bodies.

fn is_clear(material: u32) -> bool {
    return false;
}

fn pass_medium(path: ptr<function, Path>, hit: Hit) {
}

fn pass_clear(path: ptr<function, Path>, hit: Hit, surface: Surface, material: u32) -> bool {
    return false;
}

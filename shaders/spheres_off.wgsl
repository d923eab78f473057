// A scene without spheres.

fn test_spheres(probe: Probe, begin: u32, end: u32, hit: ptr<function, Hit>) -> u32 {
    return end;
}

fn sphere_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
}

fn sphere_is_left(ray: Ray, hit: Hit) -> bool {
    return false;
}

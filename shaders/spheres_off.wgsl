// A scene without spheres.

fn test_sphere(probe: Probe, row: u32, hit: ptr<function, Hit>) {
}

fn closest_sphere(probe: Probe, hit: ptr<function, Hit>) {
}

fn sphere_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
}

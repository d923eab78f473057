// A scene without triangles.

struct Shear {
    unused: u32,
}

fn shear_of(ray: Ray) -> Shear {
    return Shear(0u);
}

fn test_triangle(probe: Probe, row: u32, hit: ptr<function, Hit>) {
}

fn closest_triangle(probe: Probe, hit: ptr<function, Hit>) {
}

fn triangle_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
}

// A scene without triangles.

struct Shear {
    unused: u32,
}

fn shear_of(ray: Ray) -> Shear {
    return Shear(0u);
}

fn test_triangles(probe: Probe, begin: u32, end: u32, hit: ptr<function, Hit>) -> u32 {
    return end;
}

fn triangle_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
}

fn triangle_is_left(ray: Ray, hit: Hit) -> bool {
    return false;
}

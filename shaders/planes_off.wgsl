// A scene without planes.

fn closest_plane(probe: Probe, hit: ptr<function, Hit>) {
}

fn plane_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
}

fn plane_is_left(ray: Ray, hit: Hit) -> bool {
    return false;
}

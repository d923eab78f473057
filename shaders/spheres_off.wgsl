// A scene without spheres.

fn closest_sphere(ray: Ray, hit: ptr<function, Hit>) {
}

fn sphere_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
}

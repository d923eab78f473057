// A scene without triangles.

fn closest_triangle(ray: Ray, hit: ptr<function, Hit>) {
}

fn triangle_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
}

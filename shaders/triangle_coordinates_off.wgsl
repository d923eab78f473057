// A scene without triangles.

fn triangle_coordinates(ray: Ray, hit: Hit, coordinates: ptr<function, vec2<f32>>) -> bool {
    return false;
}

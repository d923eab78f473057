// A scene without spheres.

fn sphere_coordinates(
    hit: Hit,
    surface: Surface,
    coordinates: ptr<function, vec2<f32>>,
) -> bool {
    return false;
}

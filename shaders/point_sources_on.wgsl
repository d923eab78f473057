// Light from points.

// What comes from a point light, which has no size.
fn arriving_from_point(light: u32, position: vec3<f32>) -> Arriving {
    let lamp = light_at(light);
    let towards = lamp.vector - position;
    let square = dot_product_f32(towards, towards);
    if square == 0.0 {
        return nothing_arriving();
    }
    var arriving = nothing_arriving();
    arriving.towards = towards;
    arriving.length = square_root_f32(square);
    arriving.color = lamp.color;
    if (lamp.flags & WEAKENS) != 0u {
        arriving.square = square;
    }
    arriving.goal = lamp.vector;
    arriving.limit = shadow_limit(lamp.flags, 1.0);
    return arriving;
}

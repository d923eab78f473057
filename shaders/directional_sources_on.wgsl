// Light from infinitely far away.

// What comes from a directional light.
fn arriving_from_direction(light: u32) -> Arriving {
    let lamp = light_at(light);
    var arriving = nothing_arriving();
    arriving.towards = lamp.vector;
    arriving.color = lamp.color;
    arriving.goal = lamp.vector;
    arriving.is_far = true;
    arriving.limit = shadow_limit(lamp.flags, ENDLESS);
    return arriving;
}

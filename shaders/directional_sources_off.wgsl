// No directional lights.

fn arriving_from_direction(light: u32) -> Arriving {
    return nothing_arriving();
}

// No lamps that have a size.

fn count_lamps() -> u32 {
    return 0u;
}

fn arriving_from_lamp(lamp: u32, path: Path, surface: Surface) -> Arriving {
    return nothing_arriving();
}

fn weight_of_lamp(path: Path, hit: Hit, surface: Surface, material: u32) -> f32 {
    return 1.0;
}
